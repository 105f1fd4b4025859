#include "net/access.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace amalgam::net {
namespace {

constexpr Rights kView{.view = true, .environment = false};
constexpr Rights kAll{.view = true, .environment = true};

TEST(Access, OnlyAWholeTokenIsOne) {
  const std::vector<Grant> grants{{"opensesame", kAll}, {"guest", kView}};
  EXPECT_EQ(rights_of("opensesame", grants), kAll);
  EXPECT_EQ(rights_of("guest", grants), kView);
  for (const std::string wrong : {"", "opensesam", "opensesamf", "opensesame ", "GUEST"}) {
    EXPECT_FALSE(rights_of(wrong, grants)) << wrong;
  }
  EXPECT_EQ(rights_of("anything", {}), kAll);
}

class GrantFile : public testing::Test {
 protected:
  std::string write(const std::string& text) const {
    namespace fs = std::filesystem;
    std::ofstream(path_, std::ios::binary) << text;
    fs::permissions(path_, fs::perms::owner_read | fs::perms::owner_write);
    return path_;
  }
  void TearDown() override { std::filesystem::remove(path_); }
  const std::string path_ = testing::TempDir() + "grants_" +
                            testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(GrantFile, ALineForEachToken) {
  const auto grants = read_grants(write("guest view\n\nboss environment\r\nold \n"));
  ASSERT_EQ(grants.size(), 3u);
  EXPECT_EQ(grants[0].token, "guest");
  EXPECT_EQ(grants[0].rights, kView);
  EXPECT_EQ(grants[1].rights, kAll);
  EXPECT_EQ(grants[2].rights, kAll);
}

// Faults row 31: whoever starts such a server would have an open one, or one for nobody.
TEST_F(GrantFile, WhatCannotBeMeantIsRefused) {
  namespace fs = std::filesystem;
  EXPECT_THROW(read_grants(write("  \n")), std::runtime_error);
  EXPECT_THROW(read_grants(write("caf\xe9\n")), std::runtime_error);
  EXPECT_THROW(read_grants("/nonexistent/token"), std::runtime_error);
  try {
    read_grants(write("open sesame\n"));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("line 1"));
    EXPECT_THAT(error.what(), Not(testing::HasSubstr("sesame")));
  }
  try {
    read_grants(write("guest\n\n\nopen sesame\n"));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("line 4")) << "empty lines count as lines";
  }
  const std::string path = write("guest\n");
  for (const fs::perms loose : {fs::perms::others_read, fs::perms::others_write}) {
    fs::permissions(path, fs::perms::owner_read | loose);
    EXPECT_THROW(read_grants(path), std::runtime_error);
  }
}

}  // namespace
}  // namespace amalgam::net
