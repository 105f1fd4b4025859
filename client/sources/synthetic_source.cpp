#include "client/sources/synthetic_source.h"

#include <opencv2/imgproc.hpp>

#include "client/sources/jpeg_bytes.h"

namespace amalgam::client {

std::optional<CapturedFrame> SyntheticSource::next() {
  SyntheticFrame synthetic = camera_.render(frame_++);
  CapturedFrame frame;
  // The moment that the picture is there: drawing it is no part of the delay of a real camera.
  frame.captured_at = std::chrono::steady_clock::now();
  const cv::Mat rgb(synthetic.image.height(), synthetic.image.width(), CV_8UC3,
                    synthetic.image.data());
  cv::cvtColor(rgb, frame.bgr, cv::COLOR_RGB2BGR);
  frame.jpeg = encode_jpeg(frame.bgr, jpeg_quality_);
  if (with_true_poses_) frame.true_poses = {synthetic.pose};
  return frame;
}

}  // namespace amalgam::client
