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

TEST(LogDeathTest, AFailedChecksOwnLinesStayLines) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_DEATH(AMALGAM_CHECK(1 > 2, std::string("one\ntwo\x1b[2J")), "one\ntwo \\[2J");
}

// A client's or file's text cannot begin a line of its own, nor command a terminal.
TEST(Log, TextOfStrangersStaysInItsLine) {
  testing::internal::CaptureStderr();
  log_warn("client said: a\n2026-01-01 error forged\x1b[2J");
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_EQ(text.find('\n'), text.size() - 1) << text;
  EXPECT_NE(text.find("warning client said: a 2026-01-01 error forged [2J"), text.npos) << text;
}

}  // namespace
}  // namespace amalgam::common
