// All surfaces on a straight line, nearest first: for asking what lies between two points, and what
// a point lies in. Shadow rays need no order while they go and take trace/shadow.h's way.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "trace/refine_hit.h"
#include "trace/surface_point.h"

namespace amalgam::trace {

// More surfaces than this on one way are not asked for: a bound against meshes that never end.
inline constexpr int kMaxSurfacesOnWay = 256;

// Calls visit(const SurfacePoint&, t) for each surface that the ray meets, nearest first, masked
// texels too. The surfaces are those of the line that begins at start and t is from there; the ray
// lies on it and may begin a little later. It returns what the way may meet from there on, or
// nothing if that was enough. The same ray goes on behind each hit, so that no surface is met twice
// and none left out but such as lie at the very same t, or face the same way in one instance within
// 4e-7 t of each other. Returns false if there were too many.
template <typename Visit>
bool walk_visibility(const EmbreeScene& scene, const glm::dvec3& start, Ray ray, Visible visible,
                     const Visit& visit) {
  const glm::dvec3 direction(ray.direction);
  const double ahead = glm::distance(start, glm::dvec3(ray.origin));
  struct {
    std::uint32_t instance = 0;
    bool front = false;
    double t = -1.0;
  } last;
  for (int i = 0; i < kMaxSurfacesOnWay; ++i) {
    const auto hit = scene.intersect(ray, visible);
    if (!hit) return true;
    Hit traced = *hit;
    traced.t += ahead;
    const Hit on_line = refine_hit(scene, traced, start, direction, visible);
    const SurfacePoint point = surface_point(scene, on_line, direction);
    // On an edge Embree may meet both triangles, where the line enters or leaves once.
    constexpr double kSame = 4e-7;
    const bool again = on_line.instance == last.instance && point.front == last.front &&
                       std::abs(on_line.t - last.t) <= kSame * on_line.t;
    if (!again) {
      const std::optional<Visible> next = visit(point, on_line.t);
      if (!next) return true;
      visible = *next;
    }
    last = {on_line.instance, point.front, on_line.t};
    ray.t_min = std::nextafter(static_cast<float>(hit->t), std::numeric_limits<float>::infinity());
  }
  return false;
}

}  // namespace amalgam::trace
