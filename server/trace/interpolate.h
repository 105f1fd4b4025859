// Interpolates the attributes of a triangle's corners.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace amalgam::trace {

// barycentric: weights of the second and third corner, in the attribute's precision.
template <typename V>
V interpolate(const V& a, const V& b, const V& c,
              const glm::vec<2, typename V::value_type>& barycentric) {
  return a * (1 - barycentric.x - barycentric.y) + b * barycentric.x + c * barycentric.y;
}

template <typename V>
V interpolate(const std::vector<V>& values, const glm::uvec3& corners,
              const glm::vec<2, typename V::value_type>& barycentric) {
  return interpolate(values[corners.x], values[corners.y], values[corners.z], barycentric);
}

}  // namespace amalgam::trace
