#include "bench/picture_error.h"

#include <cstdlib>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/quality/qualityssim.hpp>
#include <stdexcept>

namespace amalgam::bench {
namespace {

// The image's own bytes, for reading. OpenCV takes no constant data.
cv::Mat as_matrix(const common::ImageRgb8& image) {
  auto* bytes = const_cast<common::Rgb8*>(image.data());
  return {image.height(), image.width(), CV_8UC3, bytes};
}

cv::Mat as_grey(const common::ImageRgb8& image) {
  cv::Mat grey;
  cv::cvtColor(as_matrix(image), grey, cv::COLOR_RGB2GRAY);
  return grey;
}

void check_sizes(const common::ImageRgb8& a, const common::ImageRgb8& b) {
  if (a.size() != b.size() || a.empty()) {
    throw std::invalid_argument("pictures of different sizes cannot be compared");
  }
}

}  // namespace

double mean_difference(const common::ImageRgb8& a, const common::ImageRgb8& b) {
  check_sizes(a, b);
  const auto first = a.pixels(), second = b.pixels();
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (int c = 0; c < 3; ++c) sum += std::abs(int{first[i][c]} - int{second[i][c]});
  }
  return static_cast<double>(sum) / (3.0 * static_cast<double>(first.size()));
}

double ssim(const common::ImageRgb8& a, const common::ImageRgb8& b) {
  check_sizes(a, b);
  return cv::quality::QualitySSIM::compute(as_grey(a), as_grey(b), cv::noArray())[0];
}

common::Image<float> ssim_map(const common::ImageRgb8& a, const common::ImageRgb8& b) {
  check_sizes(a, b);
  cv::Mat quality, floats;
  cv::quality::QualitySSIM::compute(as_grey(a), as_grey(b), quality);
  quality.convertTo(floats, CV_32F);
  common::Image<float> map(a.width(), a.height());
  floats.copyTo(cv::Mat(map.height(), map.width(), CV_32F, map.data()));
  return map;
}

double psnr(const common::ImageRgb8& a, const common::ImageRgb8& b) {
  check_sizes(a, b);
  // OpenCV keeps away from infinity.
  if (a == b) return std::numeric_limits<double>::infinity();
  return cv::PSNR(as_matrix(a), as_matrix(b));
}

}  // namespace amalgam::bench
