#include "client/calibrate.h"

#include <cstdio>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "client/sources/jpeg_bytes.h"
#include "client/tracking/lens_calibration.h"
#include "client/tracking/marker_tracker.h"
#include "common/whole_file.h"

namespace amalgam::client {
namespace {

const char* advice(LensCalibration::Offer offer) {
  switch (offer) {
    case LensCalibration::Offer::Taken:
      return "taken; turn or move the board";
    case LensCalibration::Offer::TooFewMarkers:
      return "show the whole board";
    case LensCalibration::Offer::LikeAnother:
      return "turn or move the board";
    case LensCalibration::Offer::Full:
      return "enough";
  }
  return "";
}

void show(FrameSink& sink, std::uint64_t number, const CapturedFrame& frame,
          const std::vector<tracking::DetectedMarker>& markers) {
  cv::Mat picture = frame.bgr.clone();
  for (const tracking::DetectedMarker& marker : markers) {
    for (const glm::dvec2& corner : marker.corners) {
      cv::circle(picture, cv::Point2d(corner.x, corner.y), 4, cv::Scalar(0, 255, 0), 1,
                 cv::LINE_AA);
    }
  }
  constexpr int kQuality = 85;
  sink.show(number, encode_jpeg(picture, kQuality));
}

void say(const LensCalibration& lens, LensCalibration::Offer offer) {
  std::fprintf(stderr, "\r%2zu views, %3.0f %% of the picture: %-32s", lens.views(),
               100.0 * lens.coverage(), advice(offer));
}

}  // namespace

void calibrate(const Options& options, CameraSource& source, FrameSink* sink,
               const std::atomic<bool>& stop) {
  common::check_writable(options.calibrate);
  const cv::Size size = source.size();
  LensCalibration lens(*options.viewer.board, size);
  MarkerTracker tracker({.dictionary = options.dictionary, .board = options.viewer.board},
                        common::default_camera(size.width, size.height));
  std::uint64_t number = 0;
  while (!stop && !lens.is_enough() && !(sink && sink->wants_to_stop())) {
    const auto frame = source.next();
    if (!frame) break;
    const auto markers = tracker.detect(frame->bgr);
    const LensCalibration::Offer offer = lens.offer(markers);
    say(lens, offer);
    if (sink) show(*sink, ++number, *frame, markers);
  }
  std::fputc('\n', stderr);
  const LensCalibration::Result result = lens.solve();
  write_calibration(options.calibrate, result);
  const double width = 2.0 * std::atan(0.5 * size.width / result.camera.fx);
  std::printf(
      "%s: %zu views, the board turned by %.0f degrees, reprojection error %.2f pixels, "
      "the lens is %.1f degrees wide\n",
      options.calibrate.c_str(), lens.views(), result.tilt, result.error,
      width * 180.0 / std::numbers::pi);
}

}  // namespace amalgam::client
