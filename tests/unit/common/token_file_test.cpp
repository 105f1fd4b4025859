#include "common/token_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace amalgam::common {
namespace {

constexpr std::size_t kMost = 1024;  // bytes

class TokenFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) {
    std::ofstream(path_, std::ios::binary) << text;
    return path_;
  }
  void TearDown() override { std::filesystem::remove(path_); }

  const std::string name_ = testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::filesystem::path path_ =
      std::filesystem::path(testing::TempDir()) / ("token_" + name_);
};

TEST_F(TokenFile, WhiteSpaceAtTheEndsIsNoPartOfIt) {
  EXPECT_EQ(read_token_file(write(" opensesame\r\n"), kMost), "opensesame");
}

TEST_F(TokenFile, MustHoldSomethingButNotTooMuch) {
  EXPECT_THROW(read_token_file(write("\n \n"), kMost), std::runtime_error);
  EXPECT_THROW(read_token_file(write("open sesame"), kMost), std::runtime_error);
  EXPECT_THROW(read_token_file(write("caf\xe9"), kMost), std::runtime_error);
  EXPECT_EQ(read_token_file(write(std::string(1024, 's')), kMost).size(), 1024u);
  EXPECT_THROW(read_token_file("/nonexistent/token", kMost), std::runtime_error);
  try {
    read_token_file(write(std::string(1025, 's')), kMost);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), Not(testing::HasSubstr("ssss")));
  }
}

}  // namespace
}  // namespace amalgam::common
