#include "client/sources/capture_source.h"

#include <array>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "client/sources/jpeg_bytes.h"

namespace amalgam::client {

CaptureSource CaptureSource::device(int number, cv::Size size, int jpeg_quality) {
  const std::string name = "camera " + std::to_string(number);
  cv::VideoCapture capture(number);
  if (!capture.isOpened()) throw std::runtime_error(name + " cannot be opened");
  if (!size.empty()) {
    capture.set(cv::CAP_PROP_FRAME_WIDTH, size.width);
    capture.set(cv::CAP_PROP_FRAME_HEIGHT, size.height);
  }
  return {std::move(capture), true, size, jpeg_quality, name};
}

CaptureSource CaptureSource::film(const std::string& file, cv::Size size, int jpeg_quality) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw std::runtime_error(file + ": no such file");
  }
  cv::VideoCapture capture(file);
  if (!capture.isOpened()) throw std::runtime_error(file + " is no film that can be read");
  // OpenCV 4.6 turns films the wrong way by their rotation tag (opencv issue 22088), so we turn
  // them.
  capture.set(cv::CAP_PROP_ORIENTATION_AUTO, 0);
  return {std::move(capture), false, size, jpeg_quality, file};
}

namespace {

// CAP_PROP_ORIENTATION_META up to OpenCV 4.6 is FFmpeg's angle, counter-clockwise; later versions
// negate it.
constexpr bool kMetaIsClockwise = CV_VERSION_MAJOR > 4 || CV_VERSION_MINOR > 6;

// Turns a frame so many degrees clockwise, to the next quarter.
void turn(cv::Mat& frame, int degrees) {
  const int turns = ((degrees % 360 + 360) % 360 + 45) / 90 % 4;
  constexpr std::array kTurns{cv::ROTATE_90_CLOCKWISE, cv::ROTATE_180,
                              cv::ROTATE_90_COUNTERCLOCKWISE};
  if (turns == 0) return;
  cv::Mat turned;
  cv::rotate(frame, turned, kTurns[static_cast<std::size_t>(turns - 1)]);
  frame = turned;
}

}  // namespace

bool CaptureSource::read(cv::Mat& frame) {
  if (!capture_.read(frame) || frame.empty()) return false;
  if (!live_) {
    const int meta = static_cast<int>(capture_.get(cv::CAP_PROP_ORIENTATION_META));
    turn(frame, kMetaIsClockwise ? meta : -meta);
  }
  return true;
}

CaptureSource::CaptureSource(cv::VideoCapture capture, bool live, cv::Size size, int jpeg_quality,
                             const std::string& name)
    : capture_(std::move(capture)), size_(size), live_(live), jpeg_quality_(jpeg_quality) {
  if (!read(first_)) throw std::runtime_error(name + " has no frames");
  if (size_.empty()) size_ = first_.size();
}

std::optional<CapturedFrame> CaptureSource::next() {
  CapturedFrame frame;
  if (!first_.empty()) {
    cv::swap(frame.bgr, first_);
  } else if (!read(frame.bgr)) {
    return std::nullopt;
  }
  frame.captured_at = std::chrono::steady_clock::now();
  if (frame.bgr.size() != size_) {
    cv::Mat scaled;
    cv::resize(frame.bgr, scaled, size_, 0, 0, cv::INTER_AREA);
    frame.bgr = scaled;
  }
  frame.bgr = frame.bgr.clone();  // the capture reuses its buffer
  frame.jpeg = encode_jpeg(frame.bgr, jpeg_quality_);
  return frame;
}

}  // namespace amalgam::client
