// Visits the surfaces along a ray, nearest first. Visibility rays find occluders with it, and
// media_at() the media around a point. Shadow rays need no order and use trace/shadow.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "trace/refine_hit.h"
#include "trace/surface_point.h"

namespace amalgam::trace {

// The walk stops after this many surfaces, so that no mesh makes it endless.
inline constexpr int kMaxSurfacesOnWay = 256;

// Calls visit(const SurfacePoint&, t) for each surface on the ray, alpha cut-outs included. t is
// measured from start; the ray lies on the line from start and may begin a little before. What it
// meets up to start is not visited. visit returns which objects (Visible) the walk may
// meet next, or nothing to stop. After each hit the same ray continues behind it, so no surface is
// visited twice. Of surfaces at the same t, or of one instance facing the same way within 4e-7 t of
// each other, one is visited. Returns false if the walk was cut at kMaxSurfacesOnWay.
template <typename Visit>
bool walk_visibility(const EmbreeScene& scene, const glm::dvec3& start, Ray ray, Visible visible,
                     const Visit& visit) {
  const glm::dvec3 direction(ray.direction);
  const double begins = glm::dot(glm::dvec3(ray.origin) - start, direction);  // a t
  struct {
    std::uint32_t instance = 0;
    bool front = false;
    double t = -1.0;
  } last;
  for (int i = 0; i < kMaxSurfacesOnWay; ++i) {
    const auto hit = scene.intersect(ray, visible);
    if (!hit) return true;
    // Not 0 in the tracer's threads, where denormals are.
    ray.t_min =
        std::nextafter(std::max(static_cast<float>(hit->t), std::numeric_limits<float>::min()),
                       std::numeric_limits<float>::infinity());
    if (is_left_behind(scene, *hit, start, ray)) continue;
    Hit traced = *hit;
    traced.t += begins;
    const Hit on_line = refine_hit(scene, traced, start, direction, visible);
    const SurfacePoint point = surface_point(scene, on_line, direction);
    // On an edge Embree may report both triangles, although the line enters or leaves once.
    constexpr double kSame = 4e-7;
    const bool again = on_line.instance == last.instance && point.front == last.front &&
                       std::abs(on_line.t - last.t) <= kSame * on_line.t;
    if (!again) {
      const std::optional<Visible> next = visit(point, on_line.t);
      if (!next) return true;
      visible = *next;
    }
    last = {on_line.instance, point.front, on_line.t};
  }
  return false;
}

}  // namespace amalgam::trace
