#include "client/sources/images_source.h"

#include <glob.h>

#include <algorithm>
#include <fstream>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "client/sources/jpeg_bytes.h"

namespace amalgam::client {
namespace {

std::vector<std::filesystem::path> matching_files(const std::vector<std::string>& patterns) {
  std::vector<std::filesystem::path> files;
  for (const std::string& pattern : patterns) {
    // A name with brackets is a name first.
    std::error_code error;
    if (std::filesystem::exists(pattern, error)) {
      files.emplace_back(pattern);
      continue;
    }
    glob_t matches{};
    const int result = glob(pattern.c_str(), GLOB_TILDE, nullptr, &matches);
    for (std::size_t i = 0; result == 0 && i < matches.gl_pathc; ++i) {
      files.emplace_back(matches.gl_pathv[i]);
    }
    globfree(&matches);
    if (result != 0) throw std::runtime_error("no image matches '" + pattern + "'");
  }
  std::ranges::sort(files);
  return files;
}

cv::Mat decode(const std::filesystem::path& file, const Bytes& bytes) {
  cv::Mat image = decode_image(bytes);
  if (image.empty()) throw std::runtime_error(file.string() + " is no image that can be read");
  return image;
}

}  // namespace

ImagesSource::ImagesSource(const ImagesOptions& options)
    : options_(options), files_(matching_files(options.patterns)), size_(options.size) {
  if (files_.empty()) throw std::runtime_error("no images");
  // A missing one is said now, and not when the server waits for it.
  for (const std::filesystem::path& file : files_) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error) || !std::ifstream(file)) {
      throw std::runtime_error(file.string() + " cannot be read");
    }
  }
  if (size_.empty()) size_ = decode(files_[0], read_picture("image", files_[0])).size();
}

std::optional<CapturedFrame> ImagesSource::next() {
  if (next_ == files_.size() && options_.repeat) next_ = 0;
  if (next_ == files_.size()) return std::nullopt;
  const std::filesystem::path& file = files_[next_++];
  CapturedFrame frame;
  frame.captured_at = std::chrono::steady_clock::now();
  frame.jpeg = read_picture("image", file);
  frame.bgr = decode(file, frame.jpeg);
  bool as_it_is = is_sendable_jpeg(frame.jpeg);
  if (frame.bgr.size() != size_) {
    if (options_.size.empty()) {
      throw std::runtime_error(file.string() + " has another size than the first image");
    }
    cv::Mat scaled;
    cv::resize(frame.bgr, scaled, size_, 0, 0, cv::INTER_AREA);
    frame.bgr = scaled;
    as_it_is = false;
  }
  if (!as_it_is) frame.jpeg = encode_jpeg(frame.bgr, options_.jpeg_quality);
  return frame;
}

}  // namespace amalgam::client
