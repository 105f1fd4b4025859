#include "client/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace amalgam::client {
namespace {

using testing::HasSubstr;

std::optional<Options> parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "amalgam-client");
  return parse_options(static_cast<int>(arguments.size()), arguments.data());
}

// What the program would say; empty: nothing is wrong.
std::string mistake(const std::vector<const char*>& arguments) {
  try {
    parse(arguments);
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(Options, CalibratingNeedsABoard) {
  EXPECT_EQ(mistake({"--synthetic", "--calibrate", "lens.yml"}),
            "--calibrate needs a board: --charuco, --grid or --board");
  const auto with =
      parse({"--synthetic", "--calibrate", "lens.yml", "--charuco", "5x7:0.035:0.026"});
  ASSERT_TRUE(with);
  EXPECT_EQ(with->calibrate, "lens.yml");
  EXPECT_EQ(with->viewer.board->markers.size(), 17u);
}

TEST(Options, CalibratingIsNotForACameraThatIsCalibrated) {
  const std::string both = mistake({"--synthetic", "--calibrate", "lens.yml", "--charuco",
                                    "5x7:0.035:0.026", "--calibration", "lens.yml"});
  EXPECT_THAT(both, HasSubstr("--calibration"));
  EXPECT_THAT(both, HasSubstr("excludes"));
}

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
  EXPECT_EQ(parse({"--synthetic", "--rate", "25"})->viewer.rate, 25.0);
  for (const char* name : {"--rate", "--connect-timeout", "--dead-band", "--fov"}) {
    EXPECT_TRUE(parse({"--synthetic", name, "12.5"})) << name;
    for (const char* bad : {"nan", "-1", "inf", "x"}) {
      EXPECT_THROW(parse({"--synthetic", name, bad}), std::invalid_argument) << name << " " << bad;
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
