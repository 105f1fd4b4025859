#include "common/log.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace amalgam::common {
namespace {

TEST(Log, OnlyKnownLevelsAreTaken) {
  EXPECT_THROW(set_log_level("loud"), std::invalid_argument);
  EXPECT_THROW(set_log_level(""), std::invalid_argument);
  for (const char* level : {"trace", "debug", "warn", "error", "off", "info"}) {
    EXPECT_NO_THROW(set_log_level(level)) << level;
  }
}

TEST(LogDeathTest, AFailedCheckPrintsItsValuesAndAborts) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_DEATH(AMALGAM_CHECK(1 > 2, std::string("one=1 two=2")), "1 > 2.*one=1 two=2");
}

}  // namespace
}  // namespace amalgam::common
