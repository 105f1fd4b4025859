// The two shapes that the reference intersects: triangles, which scenes are made of, and balls,
// which have closed forms (numerics B6).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "support/reference/ray.h"

namespace amalgam::reference {

struct Box {
  Vec3 low{kInfinity};
  Vec3 high{-kInfinity};

  void include(const Vec3& point);
  void include(const Box& box);
};

// World frame, metres.
struct Triangle {
  std::array<Vec3, 3> corners{};
  std::array<Vec3, 3> normals{};  // interpolated as they are, and made unit then
  Vec3 geometric_normal{0.0};     // unit, outwards even if the mesh is mirrored
  std::uint32_t object = 0;
};

struct Ball {
  Vec3 centre{0.0};
  double radius = 1.0;
  std::uint32_t object = 0;
};

Box bounds(const Triangle& triangle);
Box bounds(const Ball& ball);

// The first hit in [ray.t_min, ray.t_max]. A ray may meet a ball a second time.
std::optional<Hit> intersect(const Ray& ray, const Triangle& triangle);
std::optional<Hit> intersect(const Ray& ray, const Ball& ball);

}  // namespace amalgam::reference
