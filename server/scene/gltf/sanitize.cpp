#include "scene/gltf/sanitize.h"

#include <cmath>

namespace amalgam::scene {
namespace {

float sanitized(float value, SanitizeCounts& counts) {
  if (std::isnan(value)) {
    ++counts.nan;
    return 0.0f;
  }
  if (value < 0.0f) {
    ++counts.negative;
    return 0.0f;
  }
  if (value > kMaxRadiance) {
    ++(std::isinf(value) ? counts.infinite : counts.too_large);
    return kMaxRadiance;
  }
  return value;
}

}  // namespace

std::string SanitizeCounts::describe() const {
  return std::to_string(nan) + " NaN, " + std::to_string(infinite) + " infinite, " +
         std::to_string(negative) + " negative and " + std::to_string(too_large) +
         " too large values replaced";
}

SanitizeCounts sanitize_radiance(common::ImageRgb32f& image) {
  SanitizeCounts counts;
  for (glm::vec3& pixel : image.pixels()) {
    for (int i = 0; i < 3; ++i) pixel[i] = sanitized(pixel[i], counts);
  }
  return counts;
}

}  // namespace amalgam::scene
