#include "support/reference/composite.h"

#include <cmath>

#include "support/reference/lens.h"
#include "support/reference/real_change.h"

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

Layers Layers::zero(int width, int height) {
  const common::Image<Color> black(width, height, Color(0.0));
  return {common::Image<Vec4>(width, height, Vec4(0.0)), black, black};
}

void add_sample(Layers& layers, int x, int y, const Sample& sample, const Response& response,
                bool by_ratio, double weight) {
  if (sample.met_virtual) {
    const Color mixed = tone_map(sample.mixed, response);
    layers.over.at(x, y) += weight * Vec4(mixed + sample.environment_reflection, 1.0);
    return;
  }
  const RealChange change =
      real_change(sample.mixed, sample.real, response, by_ratio && sample.real_diffuse_first);
  layers.difference.at(x, y) += weight * change.difference;
  layers.relative.at(x, y) += weight * change.relative;
}

Layers warp(const Layers& layers, const common::CameraModel& camera,
            const common::CameraModel& ideal) {
  Layers warped = Layers::zero(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const auto position = ideal_pixel(camera, ideal, {x, y});
      if (!position) continue;
      warped.over.at(x, y) = sample_or_zero(layers.over, *position);
      warped.difference.at(x, y) = sample_or_zero(layers.difference, *position);
      warped.relative.at(x, y) = sample_or_zero(layers.relative, *position);
    }
  }
  return warped;
}

Color composite_color(const Layers& layers, const common::ImageRgb8& camera_image, int x, int y,
                      const Response& response) {
  const Vec4& over = layers.over.at(x, y);
  const common::Rgb8& bytes = camera_image.at(x, y);
  Color camera(srgb_decode_byte(bytes.r), srgb_decode_byte(bytes.g), srgb_decode_byte(bytes.b));
  const Color& relative = layers.relative.at(x, y);
  if (relative != Color(0.0) && over.a < 1.0) {
    const Color q = glm::max(1.0 + relative / (1.0 - over.a), Color(0.0));
    const Color scaled = tone_map(q * inverse_tone_map(camera, response), response);
    for (glm::length_t c = 0; c < 3; ++c) {
      if (relative[c] != 0.0) camera[c] = scaled[c];
    }
  }
  return Color(over) + (1.0 - over.a) * camera + layers.difference.at(x, y);
}

common::ImageRgb8 composite(const Layers& layers, const common::ImageRgb8& camera_image,
                            const Response& response) {
  common::ImageRgb8 result(camera_image.width(), camera_image.height());
  for (int y = 0; y < result.height(); ++y) {
    for (int x = 0; x < result.width(); ++x) {
      const Color color = composite_color(layers, camera_image, x, y, response);
      for (glm::length_t c = 0; c < 3; ++c) result.at(x, y)[c] = srgb_encode_byte(color[c]);
    }
  }
  return result;
}

}  // namespace amalgam::reference
