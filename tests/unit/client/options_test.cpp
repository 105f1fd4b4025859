#include "client/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace amalgam::client {
namespace {

using testing::HasSubstr;

struct Parsed {
  std::optional<Options> options;
  int exit_code = 0;
  std::string said;  // on standard error
};

Parsed parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "amalgam-client");
  Parsed parsed;
  testing::internal::CaptureStderr();
  parsed.options =
      parse_options(static_cast<int>(arguments.size()), arguments.data(), parsed.exit_code);
  parsed.said = testing::internal::GetCapturedStderr();
  return parsed;
}

TEST(ClientOptions, CalibratingNeedsABoard) {
  const Parsed without = parse({"--synthetic", "--calibrate", "lens.yml"});
  EXPECT_FALSE(without.options);
  EXPECT_NE(without.exit_code, 0);
  EXPECT_EQ(without.said,
            "amalgam-client: --calibrate needs a board: --charuco, --grid or --board\n");
  const Parsed with =
      parse({"--synthetic", "--calibrate", "lens.yml", "--charuco", "5x7:0.035:0.026"});
  ASSERT_TRUE(with.options) << with.said;
  EXPECT_EQ(with.options->calibrate, "lens.yml");
  EXPECT_EQ(with.options->viewer.board->markers.size(), 17u);
}

TEST(ClientOptions, CalibratingIsNotForACameraThatIsCalibrated) {
  const Parsed both = parse({"--synthetic", "--calibrate", "lens.yml", "--charuco",
                             "5x7:0.035:0.026", "--calibration", "lens.yml"});
  EXPECT_FALSE(both.options);
  EXPECT_THAT(both.said, HasSubstr("--calibration"));
  EXPECT_THAT(both.said, HasSubstr("excludes"));
}

}  // namespace
}  // namespace amalgam::client
