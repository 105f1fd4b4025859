#include "client/desk_texture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace amalgam::client {
namespace {

constexpr int kMinTexels = 64;  // a level below this is never needed at a desk's distance

core::ImageRgb8 half_size(const core::ImageRgb8& image) {
  core::ImageRgb8 half(image.width() / 2, image.height() / 2);
  for (int y = 0; y < half.height(); ++y) {
    for (int x = 0; x < half.width(); ++x) {
      const glm::ivec3 sum =
          glm::ivec3(image.at(2 * x, 2 * y)) + glm::ivec3(image.at(2 * x + 1, 2 * y)) +
          glm::ivec3(image.at(2 * x, 2 * y + 1)) + glm::ivec3(image.at(2 * x + 1, 2 * y + 1));
      half.at(x, y) = core::Rgb8((sum + 2) / 4);
    }
  }
  return half;
}

}  // namespace

DeskTexture::DeskTexture(const glm::dvec2& low, double side, int texels,
                         const std::function<glm::vec3(const glm::dvec2&)>& colour_at)
    : low_(low), side_(side), texel_(side / texels) {
  core::ImageRgb8 finest(texels, texels);
  for (int y = 0; y < texels; ++y) {
    for (int x = 0; x < texels; ++x) {
      const glm::dvec2 centre = low + texel_ * (glm::dvec2(x, y) + 0.5);
      finest.at(x, y) = core::Rgb8(glm::clamp(colour_at(centre) + 0.5f, 0.0f, 255.0f));
    }
  }
  levels_.push_back(std::move(finest));
  while (levels_.back().width() / 2 >= kMinTexels) levels_.push_back(half_size(levels_.back()));
}

bool DeskTexture::covers(const glm::dvec2& point) const {
  return point.x >= low_.x && point.y >= low_.y && point.x < low_.x + side_ &&
         point.y < low_.y + side_;
}

glm::vec3 DeskTexture::sample(const glm::dvec2& point, double footprint) const {
  const int finer = footprint > texel_ ? std::ilogb(footprint / texel_) : 0;
  const auto level = std::min(static_cast<std::size_t>(finer), levels_.size() - 1);
  const core::ImageRgb8& image = levels_[level];
  const glm::dvec2 at = (point - low_) * (image.width() / side_) - 0.5;
  const glm::dvec2 clamped = glm::clamp(at, glm::dvec2(0.0), glm::dvec2(image.width() - 1.001));
  const auto x = static_cast<int>(clamped.x), y = static_cast<int>(clamped.y);
  const auto fx = static_cast<float>(clamped.x - x), fy = static_cast<float>(clamped.y - y);
  const glm::vec3 upper = glm::mix(glm::vec3(image.at(x, y)), glm::vec3(image.at(x + 1, y)), fx);
  const glm::vec3 lower =
      glm::mix(glm::vec3(image.at(x, y + 1)), glm::vec3(image.at(x + 1, y + 1)), fx);
  return glm::mix(upper, lower, fy);
}

}  // namespace amalgam::client
