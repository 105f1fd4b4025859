// Frames from a camera device or a film, as cv::VideoCapture reads them.
#pragma once

#include <opencv2/videoio.hpp>
#include <string>

#include "client/sources/camera_source.h"

namespace amalgam::client {

class CaptureSource : public CameraSource {
 public:
  // A device by its number. An empty size takes the device's own. Otherwise requests that size from
  // the device, and scales frames of another size.
  static CaptureSource device(int number, cv::Size size, int jpeg_quality);
  // A film; an empty size takes the film's own.
  static CaptureSource film(const std::string& file, cv::Size size, int jpeg_quality);

  cv::Size size() const override { return size_; }
  std::optional<CapturedFrame> next() override;
  bool is_live() const override { return live_; }

 private:
  CaptureSource(cv::VideoCapture capture, bool live, cv::Size size, int jpeg_quality,
                const std::string& name);

  bool read(cv::Mat& frame);  // upright; false at the end

  cv::VideoCapture capture_;
  cv::Mat first_;  // read to learn the size
  cv::Size size_;
  bool live_;
  int jpeg_quality_;
};

}  // namespace amalgam::client
