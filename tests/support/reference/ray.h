// A ray and what it meets.
#pragma once

#include <cstdint>

#include "support/reference/vectors.h"

namespace amalgam::reference {

// A ray is the axis of a cone: what a sample stands for. The cone decides how finely textures are
// read (pictures.h) and nothing else.
struct Ray {
  Vec3 origin{0.0};
  Vec3 direction{0.0, 0.0, 1.0};  // unit
  double t_min = 0.0;             // metres
  double t_max = kInfinity;
  double width = 0.0;   // of the cone at the origin, metres
  double spread = 0.0;  // how fast it widens, metres a metre

  Vec3 at(double t) const { return origin + t * direction; }
  double width_at(double t) const { return width + t * spread; }
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
  Vec3 geometric_normal{0.0};   // unit, outwards: the side that sees corners counter-clockwise
  Vec3 shading_normal{0.0};     // unit, interpolated
  Vec3 weights{1.0, 0.0, 0.0};  // barycentric
  double covered_area = 0.0;    // m^2 of the surface's plane that lie in the ray's cone
  std::uint32_t primitive = 0;
  std::uint32_t object = 0;
};

// The ray arrives from outside.
inline bool is_front(const Ray& ray, const Hit& hit) {
  return glm::dot(ray.direction, hit.geometric_normal) < 0.0;
}

}  // namespace amalgam::reference
