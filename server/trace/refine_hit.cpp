#include "trace/refine_hit.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "trace/surface_point.h"

namespace amalgam::trace {
namespace {

// A triangle in its mesh's frame: its first corner, and its edges from there.
struct Triangle {
  glm::dvec3 a, edge_u, edge_v;
};

Triangle triangle_of(const EmbreeScene& scene, const Hit& hit) {
  const auto& corners = scene.triangle(hit).corners;
  const glm::dvec3 a(corners[0]);
  return {a, glm::dvec3(corners[1]) - a, glm::dvec3(corners[2]) - a};
}

bool is_finite(const Hit& hit) {
  return std::isfinite(hit.barycentric.x) && std::isfinite(hit.barycentric.y) &&
         std::isfinite(hit.t);
}

// By how much the point lies outside the triangle, in barycentric coordinates; negative inside.
double beside(const Hit& hit) {
  const glm::dvec2& b = hit.barycentric;
  return std::max(-b.x, std::max(-b.y, b.x + b.y - 1.0));
}

}  // namespace

// Möller and Trumbore 1997, with the line in the mesh's frame. Its direction is not normalised
// there, so that t is the same as in the world.
Hit in_plane_of(const EmbreeScene& scene, const Hit& hit, const glm::dvec3& start,
                const glm::dvec3& direction) {
  const glm::dmat4& mesh_from_world = scene.placed(hit.instance).mesh_from_world;
  const glm::dvec3 from(mesh_from_world * glm::dvec4(start, 1.0));
  const glm::dvec3 along = glm::dmat3(mesh_from_world) * direction;
  const auto [a, edge_u, edge_v] = triangle_of(scene, hit);
  const glm::dvec3 from_a = from - a;
  const glm::dvec3 p = glm::cross(along, edge_v), q = glm::cross(from_a, edge_u);
  const double scale = 1.0 / glm::dot(edge_u, p);
  return {hit.instance,
          hit.triangle,
          {glm::dot(from_a, p) * scale, glm::dot(along, q) * scale},
          glm::dot(edge_v, q) * scale};
}

bool is_left_behind(const EmbreeScene& scene, const Hit& hit, const glm::dvec3& start,
                    const Ray& ray) {
  // Offsets. Rounded to float, a ray that rises by a few millionths meets its own surface there.
  constexpr double kFar = 1 << 13;
  if (hit.t > kFar * glm::distance(start, glm::dvec3(ray.origin))) return false;
  // Offsets. A billionth of the coordinates: double's rounding under the worst transforms that
  // loading lets pass.
  constexpr double kAtStart = 1.0 / (1 << 12);
  const double t = in_plane_of(scene, hit, start, glm::dvec3(ray.direction)).t;
  return !(t > kAtStart * offset_at(scene, hit));
}

namespace {

// Traces again from just before the hit, where float is finer and no offset is needed. The ray was
// offset from its line, so it may have passed the triangle that the line meets by a few offsets: in
// a corner, by more than a thousandth of a short way.
std::optional<Hit> look_again(const EmbreeScene& scene, const Hit& near, const glm::dvec3& start,
                              const glm::dvec3& direction, Visible visible) {
  constexpr double kBack = 1e-3, kOffsets = 16.0;
  const double back =
      std::min(std::max(kBack * near.t, kOffsets * offset_at(scene, near)), 0.5 * near.t);
  const double t = near.t - back;
  const Ray ray{glm::vec3(start + t * direction), glm::vec3(direction),
                static_cast<float>(2.0 * back)};
  const auto met = scene.intersect(ray, visible);
  if (!met) return std::nullopt;
  return in_plane_of(scene, *met, start, direction);
}

// The point of the triangle's edge nearest to the line. At a grazing angle it is far from the
// line's intersection with the plane.
Hit nearest_edge(const EmbreeScene& scene, Hit hit, const glm::dvec3& start,
                 const glm::dvec3& direction) {
  const glm::dvec2 inside = glm::max(hit.barycentric, glm::dvec2(0.0));
  hit.barycentric = inside / std::max(1.0, inside.x + inside.y);
  const auto [a, edge_u, edge_v] = triangle_of(scene, hit);
  const glm::dvec3 in_mesh = a + hit.barycentric.x * edge_u + hit.barycentric.y * edge_v;
  const glm::dvec3 point(scene.placed(hit.instance).world_from_mesh * glm::dvec4(in_mesh, 1.0));
  hit.t = glm::dot(point - start, direction);
  return hit;
}

}  // namespace

Hit refine_hit(const EmbreeScene& scene, const Hit& traced, const glm::dvec3& start,
               const glm::dvec3& direction, Visible visible) {
  const Hit hit = in_plane_of(scene, traced, start, direction);
  if (!is_finite(hit) || !(hit.t > 0.0)) return traced;
  if (beside(hit) <= 0.0) return hit;
  const auto other = look_again(scene, hit, start, direction, visible);
  if (other && beside(*other) <= 0.0 && other->t > 0.0) return *other;
  constexpr double kFar = 0.01;
  if (beside(hit) >= kFar) return traced;
  return nearest_edge(scene, hit, start, direction);
}

}  // namespace amalgam::trace
