#include "trace/shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "trace/fresnel.h"

namespace amalgam::trace {
namespace {

// One solution: what the surfaces leave, and the optical depth of what lies between them. Depth is
// summed with a sign (entering at t takes sigma t away, leaving adds it), so that no pairing of
// surfaces is needed and their order does not matter.
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

// More surfaces than this on one way to a light count as opaque: a bound against meshes that never
// end.
constexpr int kMaxSurfaces = 256;

}  // namespace

ShadowAttenuation trace_shadow(const EmbreeScene& scene, const Ray& ray) {
  if (!scene.is_occluded(ray, Visible::Everything))
    return {};  // the common case, and the cheapest query
  Solution real, virtual_only;
  Ray segment = ray;
  float travelled = 0.0f;  // from ray.origin to segment.origin
  for (int surfaces = 0;; ++surfaces) {
    if (surfaces == kMaxSurfaces) {
      real.blocked = true;
      break;
    }
    // Once the mixed solution is dark, virtual objects make no difference any more.
    const auto visible = virtual_only.blocked ? Visible::Real : Visible::Everything;
    const auto hit = scene.intersect(segment, visible);
    if (!hit) break;
    const SurfacePoint point = surface_point(scene, *hit, segment.direction);
    const scene::Material& material = scene.scene().materials[point.material];
    Solution& solution = point.role == scene::Role::Real ? real : virtual_only;

    const bool masked_out = material.alpha_cutoff && point.base_color.w < *material.alpha_cutoff;
    if (masked_out) {
      // Nothing there.
    } else if (material.kind != scene::MaterialKind::Dielectric) {
      solution.blocked = true;
      if (real.blocked) break;
    } else {
      const float cosine = std::abs(glm::dot(point.shading_normal, segment.direction));
      const float through =
          point.transmission * shadow_transmittance(cosine, material.ior, material.thin);
      const float t = travelled + hit->t;
      const glm::vec3 depth =
          material.thin ? glm::vec3(0.0f) : material.absorption * (point.front ? -t : t);
      solution.pass_glass(glm::vec3(point.base_color) * through, depth);
    }
    const glm::vec3 next = point.ray_origin_on_line(segment.direction);
    travelled += glm::distance(next, segment.origin);
    segment.origin = next;
    segment.t_max = ray.t_max - travelled;
    if (!(segment.t_max > 0.0f)) break;
  }
  const glm::vec3 real_attenuation = real.attenuation();
  return {real_attenuation * virtual_only.attenuation(), real_attenuation};
}

}  // namespace amalgam::trace
