#include "support/test_output.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "codec/exr.h"

namespace amalgam::test_support {
namespace {

constexpr const char* kKinds[] = {"expected", "actual", "difference"};

bool is_finite(const glm::vec3& color) {
  return std::isfinite(color.r) && std::isfinite(color.g) && std::isfinite(color.b);
}

float largest_value(const common::ImageRgb32f& image) {
  float largest = 0.0f;
  for (const glm::vec3& color : image.pixels()) {
    if (is_finite(color)) largest = std::max({largest, color.r, color.g, color.b});
  }
  return largest;
}

void write_png(const std::filesystem::path& path, const common::ImageRgb32f& image, float white) {
  cv::Mat bgr(image.height(), image.width(), CV_8UC3);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec3& color = image.at(x, y);
      const glm::vec3 byte = is_finite(color)
                                 ? 255.0f * glm::clamp(color / white, glm::vec3(0), glm::vec3(1))
                                 : glm::vec3(255, 0, 255);
      bgr.at<cv::Vec3b>(y, x) = {cv::saturate_cast<unsigned char>(byte.b),
                                 cv::saturate_cast<unsigned char>(byte.g),
                                 cv::saturate_cast<unsigned char>(byte.r)};
    }
  }
  if (!cv::imwrite(path.string(), bgr)) {
    throw std::runtime_error(path.string() + ": cannot be written");
  }
}

std::filesystem::path file(const std::string& name, const char* kind, const char* extension) {
  return test_output_folder() / (name + "-" + kind + extension);
}

void write_picture(const std::string& name, const char* kind, const common::ImageRgb32f& image,
                   const common::ImageRgb32f& shown, float white) {
  codec::write_exr(file(name, kind, ".exr"), image);
  // A picture that is black all over has no white.
  write_png(file(name, kind, ".png"), shown, white > 0.0f ? white : 1.0f);
}

}  // namespace

std::filesystem::path test_output_folder() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  if (test == nullptr) throw std::logic_error("no test runs that could leave pictures");
  std::string name = std::string(test->test_suite_name()) + "." + test->name();
  std::replace(name.begin(), name.end(), '/', '_');
  return std::filesystem::path(AMALGAM_BINARY_DIR) / "test_output" / name;
}

std::string write_test_output(const std::string& name, const common::ImageRgb32f& actual,
                              const common::ImageRgb32f& expected, double white_difference) {
  common::ImageRgb32f difference(actual.width(), actual.height());
  common::ImageRgb32f absolute = difference;
  for (std::size_t i = 0; i < difference.pixels().size(); ++i) {
    difference.pixels()[i] = actual.pixels()[i] - expected.pixels()[i];
    absolute.pixels()[i] = glm::abs(difference.pixels()[i]);
  }
  std::filesystem::create_directories(test_output_folder());
  const float white = std::max(largest_value(actual), largest_value(expected));
  write_picture(name, "expected", expected, expected, white);
  write_picture(name, "actual", actual, actual, white);
  write_picture(
      name, "difference", difference, absolute,
      white_difference > 0.0 ? static_cast<float>(white_difference) : largest_value(absolute));
  std::string lines;
  for (const char* kind : kKinds) lines += "  " + file(name, kind, ".png").string() + "\n";
  return lines;
}

void remove_test_output(const std::string& name) {
  for (const char* kind : kKinds) {
    for (const char* extension : {".exr", ".png"}) {
      std::filesystem::remove(file(name, kind, extension));
    }
  }
  std::error_code not_empty;
  std::filesystem::remove(test_output_folder(), not_empty);
}

}  // namespace amalgam::test_support
