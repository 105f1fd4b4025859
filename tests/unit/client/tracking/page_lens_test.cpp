// The page for browsers measures lenses too: by the same rules, and as files that are read here.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "client/tracking/calibration.h"
#include "client/tracking/lens_calibration.h"

namespace amalgam::client {
namespace {

TEST(PageLens, HasTheSameLimits) {
  std::ifstream file(AMALGAM_SOURCE_DIR "/client/web/source/lens/limits.json");
  nlohmann::json limits = nlohmann::json::parse(file);
  // Which board it is, is compared with the one that the server prints.
  limits.erase("board");
  limits.erase("dictionary");
  const nlohmann::json ours = {{"fewestMarkers", LensCalibration::kFewestMarkers},
                               {"moved", LensCalibration::kMoved},
                               {"fewestViews", LensCalibration::kFewestViews},
                               {"goodViews", LensCalibration::kGoodViews},
                               {"mostViews", LensCalibration::kMostViews},
                               {"cells", LensCalibration::kCells},
                               {"leastCoverage", LensCalibration::kLeastCoverage},
                               {"goodCoverage", LensCalibration::kGoodCoverage},
                               {"leastTilt", LensCalibration::kLeastTilt},
                               {"worstError", LensCalibration::kWorstError},
                               {"usualWidth", LensCalibration::kUsualWidth}};
  EXPECT_EQ(limits, ours);
}

// lens.yml is what tests/web/unit/lens.test.js has the page write.
TEST(PageLens, ItsFileIsRead) {
  const common::CameraModel camera =
      load_calibration(AMALGAM_SOURCE_DIR "/tests/web/data/lens.yml");
  common::CameraModel expected;
  expected.width = 640;
  expected.height = 480;
  expected.fx = 502.3456789012345;
  expected.fy = 507.25;
  expected.cx = 325.5;
  expected.cy = 235.5;
  expected.distortion = {-0.12, 0.05, 0.001, -1e-7, 0.0};
  EXPECT_EQ(camera, expected);
}

}  // namespace
}  // namespace amalgam::client
