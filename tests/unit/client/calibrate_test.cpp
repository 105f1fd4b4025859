#include "client/calibrate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "client/tracking/board_description.h"

namespace amalgam::client {
namespace {

class CountingSource : public CameraSource {
 public:
  cv::Size size() const override { return {64, 48}; }
  std::optional<CapturedFrame> next() override {
    ++asked;
    return std::nullopt;
  }
  int asked = 0;
};

// Nobody waves a board for a minute to learn that.
TEST(Calibrate, AFileThatCannotBeWrittenIsSaidBeforeTheFirstPicture) {
  Options options;
  options.viewer.board = parse_charuco_board("5x7:0.035:0.026");
  options.calibrate = testing::TempDir() + "no_such_folder/lens.yml";
  CountingSource source;
  const std::atomic<bool> stop = false;
  try {
    calibrate(options, source, nullptr, stop);
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::StartsWith(options.calibrate + ": cannot be written"));
  }
  EXPECT_EQ(source.asked, 0);
}

}  // namespace
}  // namespace amalgam::client
