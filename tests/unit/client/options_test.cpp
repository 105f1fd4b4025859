#include "client/options.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace amalgam::client {
namespace {

TEST(Options, ReadsAddressesAndSizes) {
  EXPECT_EQ(parse_server("[::1]:80"), (common::HostPort{"::1", 80}));
  EXPECT_EQ(parse_server("desk.example:7447"), (common::HostPort{"desk.example", 7447}));
  for (const char* bad :
       {"", ":80", "host", "host:", "host:0", "host:65536", "host:8x", "::1:80"}) {
    EXPECT_THROW(parse_server(bad), std::runtime_error) << bad;
  }
  EXPECT_EQ(parse_size("800x600"), cv::Size(800, 600));
  for (const char* bad : {"", "800", "800x", "x600", "0x1", "-1x5", "800x600x", "99999x2"}) {
    EXPECT_THROW(parse_size(bad), std::runtime_error) << bad;
  }
}

TEST(Options, NumbersAreNumbersWithinTheirRange) {
  const auto parse = [](const char* name, const char* value) {
    const char* const arguments[] = {"amalgam-client", "--synthetic", name, value};
    return parse_options(4, arguments);
  };
  EXPECT_EQ(parse("--rate", "25")->viewer.rate, 25.0);
  for (const char* name : {"--rate", "--connect-timeout", "--dead-band", "--fov"}) {
    EXPECT_TRUE(parse(name, "12.5")) << name;
    for (const char* bad : {"nan", "-1", "inf", "x"}) {
      EXPECT_THROW(parse(name, bad), std::invalid_argument) << name << " " << bad;
    }
  }
}

TEST(Options, ReadsSmoothing) {
  EXPECT_EQ(parse_smoothing("1.5").min_cutoff, 1.5);
  EXPECT_EQ(parse_smoothing("1.5").beta, 0.0);
  EXPECT_EQ(parse_smoothing("1:20").beta, 20.0);
  for (const char* bad :
       {"", "0", "-1", "x", "1:", "1:x", "1:-1", "1:2:3", "nan", "inf", "1:nan"}) {
    EXPECT_THROW(parse_smoothing(bad), std::runtime_error) << bad;
  }
}

}  // namespace
}  // namespace amalgam::client
