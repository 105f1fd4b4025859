// A ray and what it meets.
#pragma once

#include <cstdint>

#include "support/reference/vectors.h"

namespace amalgam::reference {

struct Ray {
  Vec3 origin{0.0};
  Vec3 direction{0.0, 0.0, 1.0};  // unit
  double t_min = 0.0;             // metres
  double t_max = kInfinity;

  Vec3 at(double t) const { return origin + t * direction; }
};

// A ray that leaves a surface: what lies within 1e-9 (m, or relative to the distance from the
// world's origin) is the surface itself. The origin stays where it is.
inline Ray ray_from_surface(const Vec3& origin, const Vec3& direction, double t_max = kInfinity) {
  const double size = std::max({1.0, std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)});
  return {origin, direction, 1e-9 * size, t_max};
}

struct Hit {
  double t = kInfinity;
  Vec3 position{0.0};
  Vec3 geometric_normal{0.0};  // unit, outwards: the side that sees corners counter-clockwise
  Vec3 shading_normal{0.0};    // unit, interpolated
  Vec2 uv{0.0};
  std::uint32_t object = 0;
};

// The ray arrives from outside.
inline bool is_front(const Ray& ray, const Hit& hit) {
  return glm::dot(ray.direction, hit.geometric_normal) < 0.0;
}

}  // namespace amalgam::reference
