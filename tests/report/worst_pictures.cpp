#include "report/worst_pictures.h"

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "scene/light/tone_map.h"

namespace amalgam::report {

std::string as_png(const common::ImageRgb8& image) {
  // OpenCV takes no constant data; it is not written to.
  const cv::Mat rgb(image.height(), image.width(), CV_8UC3,
                    const_cast<common::Rgb8*>(image.data()));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  std::vector<unsigned char> bytes;
  cv::imencode(".png", bgr, bytes);
  return {bytes.begin(), bytes.end()};
}

common::ImageRgb8 difference_picture(const common::ImageRgb32f& actual,
                                     const common::ImageRgb32f& expected) {
  common::ImageRgb8 result(actual.width(), actual.height());
  for (int y = 0; y < result.height(); ++y) {
    for (int x = 0; x < result.width(); ++x) {
      glm::vec3 shown = kDifferenceGain * glm::abs(actual.at(x, y) - expected.at(x, y));
      for (glm::length_t c = 0; c < 3; ++c) {
        if (!std::isfinite(shown[c])) shown = glm::vec3(1.0f);
      }
      result.at(x, y) = scene::srgb_encode(shown);
    }
  }
  return result;
}

}  // namespace amalgam::report
