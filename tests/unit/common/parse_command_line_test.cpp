#include "common/parse_command_line.h"

#include <gtest/gtest.h>

namespace amalgam::common {
namespace {

template <typename Number>
bool takes(Number low, Number high, const std::string& text) {
  CLI::App app;
  Number value{};
  app.add_option("--value", value)->check(in_range(low, high));
  const char* const arguments[] = {"program", "--value", text.c_str()};
  try {
    return parse_command_line(app, 3, arguments);
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return false;
  }
}

TEST(InRange, TakesNumbersFromTheFirstToTheLast) {
  for (const char* good : {"0.5", "1", "2"}) EXPECT_TRUE(takes(0.5, 2.0, good)) << good;
  for (const char* bad : {"0.49", "2.01", "-1", "inf", "x", "1x", ""}) {
    EXPECT_FALSE(takes(0.5, 2.0, bad)) << bad;
  }
  EXPECT_TRUE(takes(1, 3, "3"));
  for (const char* bad : {"0", "4", "1.5", "99999999999999999999"}) {
    EXPECT_FALSE(takes(1, 3, bad)) << bad;
  }
}

// It is neither below nor above anything.
TEST(InRange, RefusesNaN) {
  for (const char* nan : {"nan", "-nan", "NAN"}) EXPECT_FALSE(takes(0.5, 2.0, nan)) << nan;
}

}  // namespace
}  // namespace amalgam::common
