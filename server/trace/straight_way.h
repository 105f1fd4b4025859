// All surfaces on a straight way: what light for shadows, and the question of what lies between two
// points, passes.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "trace/surface_point.h"

namespace amalgam::trace {

// More surfaces than this on one way are not asked for: a bound against meshes that never end.
inline constexpr int kMaxSurfacesOnWay = 256;

// Calls visit(const SurfacePoint&, t) for each surface that the ray meets, nearest first, masked
// texels too. It returns what the way may meet from there on, or nothing if that was enough. The
// same ray goes on behind each hit, so that no surface is met twice and none left out but such as
// lie at the very same t. Returns false if there were too many.
template <typename Visit>
bool walk_straight(const EmbreeScene& scene, Ray ray, Visible visible, const Visit& visit) {
  for (int i = 0; i < kMaxSurfacesOnWay; ++i) {
    const auto hit = scene.intersect(ray, visible);
    if (!hit) return true;
    const std::optional<Visible> next =
        visit(surface_point(scene, *hit, glm::dvec3(ray.direction)), hit->t);
    if (!next) return true;
    visible = *next;
    ray.t_min = std::nextafter(static_cast<float>(hit->t), std::numeric_limits<float>::infinity());
  }
  return false;
}

}  // namespace amalgam::trace
