#include "report/picture_figures.h"

#include <algorithm>
#include <cmath>

#include "bench/picture_error.h"
#include "scene/light/tone_map.h"

namespace amalgam::report {
namespace {

constexpr double kRelativeFloor = 0.01;

}  // namespace

PictureFigures picture_figures(const common::ImageRgb32f& actual,
                               const common::ImageRgb32f& expected) {
  PictureFigures figures;
  // Checks the sizes.
  const common::ImageRgb8 actual_bytes = as_bytes(actual), expected_bytes = as_bytes(expected);
  figures.ssim = bench::ssim(actual_bytes, expected_bytes);
  figures.psnr = bench::psnr(actual_bytes, expected_bytes);
  const auto a = actual.pixels(), e = expected.pixels();
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (glm::length_t c = 0; c < 3; ++c) {
      const double reference = e[i][c];
      double error = std::abs(double{a[i][c]} - reference);
      if (!std::isfinite(a[i][c])) {
        ++figures.nonfinite;
        error = std::max(reference, 1.0 - reference);
      }
      const double relative = error / (reference + kRelativeFloor);
      figures.mae += error;
      figures.mse += error * error;
      figures.mrse += relative * relative;
      figures.maximum = std::max(figures.maximum, error);
    }
  }
  const double count = 3.0 * static_cast<double>(a.size());
  figures.mae /= count;
  figures.mse /= count;
  figures.mrse /= count;
  return figures;
}

double mean_absolute_error(const common::ImageRgb32f& actual, const common::ImageRgb32f& expected) {
  return picture_figures(actual, expected).mae;
}

common::ImageRgb8 as_bytes(const common::ImageRgb32f& display_linear) {
  common::ImageRgb8 bytes(display_linear.width(), display_linear.height());
  std::transform(display_linear.pixels().begin(), display_linear.pixels().end(), bytes.data(),
                 [](const glm::vec3& color) { return scene::srgb_encode(color); });
  return bytes;
}

common::ImageRgb32f as_light(const common::ImageRgb8& bytes) {
  common::ImageRgb32f light(bytes.width(), bytes.height());
  std::transform(bytes.pixels().begin(), bytes.pixels().end(), light.data(),
                 [](const common::Rgb8& color) { return scene::srgb_decode(color); });
  return light;
}

}  // namespace amalgam::report
