#include "trace/shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <span>
#include <tuple>

#include "trace/fresnel.h"
#include "trace/refine_hit.h"
#include "trace/surface_point.h"

namespace amalgam::trace {
namespace {

// Attenuation of one solution: the surfaces' transmittance and the optical depth between them.
// Depth is summed with a sign: entering at t subtracts sigma t, leaving adds it. So surfaces need
// no pairing and no order.
struct Solution {
  glm::vec3 surfaces{1.0f};
  glm::vec3 optical_depth{0.0f};
  bool blocked = false;

  void pass_glass(const glm::vec3& surface, const glm::vec3& depth) {
    surfaces *= surface;
    optical_depth += depth;
  }
  glm::vec3 attenuation() const {
    if (blocked) return glm::vec3(0.0f);
    return surfaces * glm::exp(-glm::max(optical_depth, glm::vec3(0.0f)));
  }
};

// Applies one surface on the shadow ray to the light.
void pass_surface(const EmbreeScene& scene, const Hit& hit, const glm::dvec3& direction,
                  Solution& solution) {
  const SurfacePoint point = surface_point(scene, hit, direction);
  const scene::Material& material = scene.scene().materials[point.material];
  if (material.alpha_cutoff && point.base_color.w < *material.alpha_cutoff) return;  // a hole
  if (material.kind != scene::MaterialKind::Dielectric) {
    solution.blocked = true;
    return;
  }
  const auto cosine = static_cast<float>(std::abs(glm::dot(point.shading_normal, direction)));
  const float through =
      point.transmission * shadow_transmittance(cosine, material.ior, material.thin);
  const auto way = static_cast<float>(point.front ? -hit.t : hit.t);
  solution.pass_glass(glm::vec3(point.base_color) * through,
                      material.thin ? glm::vec3(0.0f) : material.absorption * way);
}

bool is_front(const EmbreeScene& scene, const Hit& hit, const glm::dvec3& direction) {
  const auto& corners = scene.triangle(hit).corners;
  const glm::dvec3 a(corners[0]);
  const glm::dvec3 area = glm::cross(glm::dvec3(corners[1]) - a, glm::dvec3(corners[2]) - a);
  return glm::dot(scene.placed(hit.instance).normal_from_mesh * area, direction) < 0.0;
}

// On an edge Embree may report both triangles, although the line enters or leaves once. It may also
// report a triangle twice that its BVH has split.
bool is_same(const EmbreeScene& scene, const Hit& a, const Hit& b, const glm::dvec3& direction) {
  constexpr double kSame = 4e-7;
  if (a.instance != b.instance || std::abs(a.t - b.t) > kSame * b.t) return false;
  return a.triangle == b.triangle || is_front(scene, a, direction) == is_front(scene, b, direction);
}

// The surfaces on the line that begins at start, nearest first, each once.
std::span<Hit> put_in_order(const EmbreeScene& scene, const glm::dvec3& start, const Ray& ray,
                            std::span<Hit> hits) {
  const glm::dvec3 direction(ray.direction);
  const double begins = glm::dot(glm::dvec3(ray.origin) - start, direction);  // a t
  for (Hit& hit : hits) {
    hit.t += begins;
    const Hit on_line = in_plane_of(scene, hit, start, direction);
    // Edge-on triangles have no reliable intersection; Embree's stays.
    if (std::abs(on_line.t - hit.t) <= std::max(1e-3 * hit.t, std::abs(begins))) hit = on_line;
  }
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return std::tie(a.t, a.instance, a.triangle) < std::tie(b.t, b.instance, b.triangle);
  });
  const auto last = std::unique(hits.begin(), hits.end(), [&](const Hit& a, const Hit& b) {
    return is_same(scene, a, b, direction);
  });
  return hits.first(static_cast<std::size_t>(last - hits.begin()));
}

// Attenuation by the surfaces that find_all() met, real and virtual ones apart.
struct Solutions {
  Solution real, virtual_only;
};

Solutions pass_surfaces(const EmbreeScene& scene, const glm::dvec3& start, const Ray& ray,
                        PassedSurfaces& surfaces) {
  Solutions solutions;
  const glm::dvec3 direction(ray.direction);
  for (const Hit& hit : put_in_order(scene, start, ray, surfaces.hits())) {
    const bool real = scene.placed(hit.instance).role == scene::Role::Real;
    pass_surface(scene, hit, direction, real ? solutions.real : solutions.virtual_only);
  }
  return solutions;
}

// Attenuation by the real surfaces on the ray.
glm::vec3 real_attenuation(const EmbreeScene& scene, const glm::dvec3& start, const Ray& ray,
                           PassedSurfaces& surfaces) {
  if (!scene.anything_passes_light())
    return glm::vec3(scene.is_occluded(start, ray, Visible::Real) ? 0.0f : 1.0f);
  if (scene.find_all(start, ray, Visible::Real, surfaces) || surfaces.overflowed())
    return glm::vec3(0.0f);
  return pass_surfaces(scene, start, ray, surfaces).real.attenuation();
}

constexpr ShadowAttenuation kDark{glm::vec3(0.0f), glm::vec3(0.0f)};

}  // namespace

ShadowAttenuation trace_shadow(const EmbreeScene& scene, const glm::dvec3& start, const Ray& ray,
                               PassedSurfaces& surfaces) {
  if (!scene.anything_passes_light()) {
    if (!scene.is_occluded(start, ray, Visible::Everything)) return {};
    return {glm::vec3(0.0f), real_attenuation(scene, start, ray, surfaces)};
  }
  if (scene.find_all(start, ray, Visible::Everything, surfaces) || surfaces.overflowed())
    return kDark;
  if (surfaces.hits().empty()) return {};
  const Solutions solutions = pass_surfaces(scene, start, ray, surfaces);
  const glm::vec3 real = solutions.real.attenuation();
  return {real * solutions.virtual_only.attenuation(), real};
}

ShadowAttenuation trace_shadow_change(const EmbreeScene& scene, const glm::dvec3& start,
                                      const Ray& ray, PassedSurfaces& surfaces) {
  glm::vec3 added(0.0f);
  if (!scene.anything_passes_light()) {
    if (!scene.is_occluded(start, ray, Visible::Virtual)) return {};
  } else {
    scene.find_all(start, ray, Visible::Virtual, surfaces);
    if (surfaces.overflowed()) return kDark;
    if (surfaces.hits().empty()) return {};
    added = pass_surfaces(scene, start, ray, surfaces).virtual_only.attenuation();
    if (added == glm::vec3(1.0f)) return {};
  }
  const glm::vec3 real = real_attenuation(scene, start, ray, surfaces);
  return {real * added, real};
}

}  // namespace amalgam::trace
