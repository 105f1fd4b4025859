#include "support/reference/composite.h"

#include <cmath>

#include "support/reference/color_curves.h"
#include "support/reference/lens.h"

namespace amalgam::reference {
namespace {

template <typename Pixel>
Pixel sample_or_zero(const common::Image<Pixel>& image, const Vec2& position) {
  const double x0 = std::floor(position.x), y0 = std::floor(position.y);
  const double fx = position.x - x0, fy = position.y - y0;
  const auto value = [&](double x, double y) {
    const bool inside = x >= 0.0 && y >= 0.0 && x < image.width() && y < image.height();
    return inside ? image.at(static_cast<int>(x), static_cast<int>(y)) : Pixel(0.0);
  };
  return (1.0 - fy) * ((1.0 - fx) * value(x0, y0) + fx * value(x0 + 1.0, y0)) +
         fy * ((1.0 - fx) * value(x0, y0 + 1.0) + fx * value(x0 + 1.0, y0 + 1.0));
}

}  // namespace

void add_sample(Layers& layers, int x, int y, const Sample& sample, double exposure,
                double weight) {
  const Color mixed = tone_map(sample.mixed, exposure);
  const Color real = tone_map(sample.real, exposure);
  if (sample.met_virtual) {
    layers.over.at(x, y) += weight * Vec4(mixed + sample.environment_reflection, 1.0);
  } else {
    layers.difference.at(x, y) += weight * (mixed - real);
  }
}

Layers warp(const Layers& layers, const common::CameraModel& camera,
            const common::CameraModel& ideal) {
  Layers warped{common::Image<Vec4>(camera.width, camera.height, Vec4(0.0)),
                common::Image<Color>(camera.width, camera.height, Color(0.0))};
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const auto position = ideal_pixel(camera, ideal, {x, y});
      if (!position) continue;
      warped.over.at(x, y) = sample_or_zero(layers.over, *position);
      warped.difference.at(x, y) = sample_or_zero(layers.difference, *position);
    }
  }
  return warped;
}

common::ImageRgb8 composite(const Layers& layers, const common::ImageRgb8& camera_image) {
  common::ImageRgb8 result(camera_image.width(), camera_image.height());
  for (int y = 0; y < result.height(); ++y) {
    for (int x = 0; x < result.width(); ++x) {
      const Vec4& over = layers.over.at(x, y);
      const common::Rgb8& bytes = camera_image.at(x, y);
      for (glm::length_t c = 0; c < 3; ++c) {
        const double final_value =
            over[c] + (1.0 - over.a) * srgb_decode_byte(bytes[c]) + layers.difference.at(x, y)[c];
        result.at(x, y)[c] = srgb_encode_byte(final_value);
      }
    }
  }
  return result;
}

}  // namespace amalgam::reference
