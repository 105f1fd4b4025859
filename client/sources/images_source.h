// Frames from image files, in the order of their names.
//
// A JPEG that a server accepts is passed on byte for byte, so that a frame without a virtual effect
// comes back as the file itself. Other images are encoded.
#pragma once

#include <filesystem>
#include <string>

#include "client/sources/camera_source.h"

namespace amalgam::client {

struct ImagesOptions {
  std::vector<std::string> patterns;  // file names or glob patterns
  cv::Size size;                      // images are scaled to it; empty: the first image's
  int jpeg_quality = 92;              // of images that have to be encoded
  bool repeat = false;                // begin again after the last
};

class ImagesSource : public CameraSource {
 public:
  // Throws std::runtime_error if a pattern matches nothing or the first image cannot be read.
  explicit ImagesSource(const ImagesOptions& options);

  cv::Size size() const override { return size_; }
  std::optional<CapturedFrame> next() override;

 private:
  ImagesOptions options_;
  std::vector<std::filesystem::path> files_;
  std::size_t next_ = 0;
  cv::Size size_;
};

}  // namespace amalgam::client
