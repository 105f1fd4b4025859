// Runs a target over its kept bytes: seeds, and whatever fuzzing found. So a build without clang
// notices too when one of them breaks something again.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

#include "fuzz/target.h"

namespace amalgam::fuzz {
namespace {

namespace fs = std::filesystem;

TEST(FuzzCorpus, AMALGAM_FUZZ_TARGET) {
  const std::string target = testing::UnitTest::GetInstance()->current_test_info()->name();
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(AMALGAM_SOURCE_DIR) / "tests" / "fuzz" /
                                                  "corpus" / target)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  EXPECT_FALSE(files.empty());
  for (const fs::path& path : files) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    std::cout << path.filename().string() << std::endl;  // the last one said is the one that broke
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
}

}  // namespace
}  // namespace amalgam::fuzz
