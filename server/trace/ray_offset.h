// Secondary rays start a little off the surface, so that they do not meet it again.
//
// Wächter and Binder, A Fast and Robust Method for Avoiding Self-Intersection, Ray Tracing Gems
// (2019), ch. 6. The resolution limit that this brings: gaps below about 3.1e-5 times the distance
// from the origin (1.5e-5 m near it) are skipped (numerics B2).
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

namespace amalgam::trace {

// p: a point on the surface, from barycentric coordinates. normal: unit, on the side that the ray
// leaves to.
inline glm::vec3 offset_from_surface(const glm::vec3& p, const glm::vec3& normal) {
  constexpr float kOrigin = 1.0f / 32.0f;  // below this the fixed offset is the larger one
  constexpr float kFloatScale = 1.0f / 65536.0f;
  constexpr float kIntScale = 256.0f;  // steps in units of the last place
  glm::vec3 out;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(p[axis]) < kOrigin) {
      out[axis] = p[axis] + kFloatScale * normal[axis];
    } else {
      const auto steps = static_cast<std::int32_t>(kIntScale * normal[axis]);
      const auto bits = std::bit_cast<std::int32_t>(p[axis]);
      out[axis] = std::bit_cast<float>(bits + (p[axis] < 0.0f ? -steps : steps));
    }
  }
  return out;
}

}  // namespace amalgam::trace
