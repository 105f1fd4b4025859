#include "client/synthetic/desk_texture.h"

#include <algorithm>
#include <glm/common.hpp>

namespace amalgam::client {
namespace {

constexpr int kMinTexels = 64;  // a level below this is never needed at a desk's distance

common::Image<PackedColor> half_size(const common::Image<PackedColor>& image) {
  common::Image<PackedColor> half(image.width() / 2, image.height() / 2);
  for (int y = 0; y < half.height(); ++y) {
    for (int x = 0; x < half.width(); ++x) {
      PackedMean<4> mean;
      mean.add(image.at(2 * x, 2 * y));
      mean.add(image.at(2 * x + 1, 2 * y));
      mean.add(image.at(2 * x, 2 * y + 1));
      mean.add(image.at(2 * x + 1, 2 * y + 1));
      half.at(x, y) = pack(mean.mean());
    }
  }
  return half;
}

}  // namespace

DeskTexture::DeskTexture(const glm::dvec2& low, double side, int texels,
                         const std::function<glm::vec3(const glm::dvec2&)>& color_at)
    : low_(low), side_(side), texel_(side / texels) {
  common::Image<PackedColor> finest(texels, texels);
  for (int y = 0; y < texels; ++y) {
    for (int x = 0; x < texels; ++x) {
      const glm::dvec2 centre = low + texel_ * (glm::dvec2(x, y) + 0.5);
      finest.at(x, y) = pack(common::Rgb8(glm::clamp(color_at(centre) + 0.5f, 0.0f, 255.0f)));
    }
  }
  levels_.push_back({std::move(finest), 256.0 * texels / side});
  while (levels_.back().texels.width() / 2 >= kMinTexels) {
    common::Image<PackedColor> half = half_size(levels_.back().texels);
    const double scale = 256.0 * half.width() / side;
    levels_.push_back({std::move(half), scale});
  }
}

PackedColor DeskTexture::sample(const glm::dvec2& point, double footprint) const {
  std::size_t level = 0;
  for (double texel = 2 * texel_; texel <= footprint && level + 1 < levels_.size(); texel *= 2) {
    ++level;
  }
  const auto& [image, scale] = levels_[level];
  // Positions in 1/256 of a texel; whole ones are texels' centres.
  const int limit = 256 * (image.width() - 1) - 1;
  const int at_x = std::clamp(static_cast<int>((point.x - low_.x) * scale) - 128, 0, limit);
  const int at_y = std::clamp(static_cast<int>((point.y - low_.y) * scale) - 128, 0, limit);
  const int x = at_x >> 8, y = at_y >> 8;
  const auto weight_x = static_cast<std::uint32_t>(at_x & 255);
  const auto weight_y = static_cast<std::uint32_t>(at_y & 255);
  const PackedColor upper = mix_packed(image.at(x, y), image.at(x + 1, y), weight_x);
  const PackedColor lower = mix_packed(image.at(x, y + 1), image.at(x + 1, y + 1), weight_x);
  return mix_packed(upper, lower, weight_y);
}

}  // namespace amalgam::client
