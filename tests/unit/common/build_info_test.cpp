#include "common/build_info.h"

#include <gtest/gtest.h>

namespace amalgam::common {
namespace {

TEST(BuildInfo, SaysWhatAndForWhat) {
  EXPECT_EQ(version_line("amalgam-x").rfind("amalgam-x " + std::string(version()), 0), 0u);
  EXPECT_NE(version_line("amalgam-x").find(instruction_set()), std::string::npos);
  // This test is compiled as the library is.
#if defined(__x86_64__) && defined(__AVX2__) && defined(__FMA__)
  EXPECT_NE(std::string(instruction_set()), "x86-64");
#elif defined(__x86_64__)
  EXPECT_NE(std::string(instruction_set()), "x86-64-v3");
#endif
}

// SHA-1 as GNU's linker and lld make it; equal whenever it is asked for.
TEST(BuildInfo, TheBuildHasAnId) {
  EXPECT_GE(build_id().size(), 32u);
  EXPECT_EQ(build_id().find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(build_id(), build_id());
}

}  // namespace
}  // namespace amalgam::common
