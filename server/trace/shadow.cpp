#include "trace/shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "trace/fresnel.h"
#include "trace/straight_way.h"

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

}  // namespace

ShadowAttenuation trace_shadow(const EmbreeScene& scene, const glm::dvec3& start, const Ray& ray) {
  if (!scene.is_occluded(ray, Visible::Everything))
    return {};  // the common case, and the cheapest query
  Solution real, virtual_only;
  const auto pass = [&](const SurfacePoint& point, double t) -> std::optional<Visible> {
    const scene::Material& material = scene.scene().materials[point.material];
    Solution& solution = point.role == scene::Role::Real ? real : virtual_only;
    const bool masked_out = material.alpha_cutoff && point.base_color.w < *material.alpha_cutoff;
    if (masked_out) {
      // Nothing there.
    } else if (material.kind != scene::MaterialKind::Dielectric) {
      solution.blocked = true;
    } else {
      const auto cosine =
          static_cast<float>(std::abs(glm::dot(point.shading_normal, glm::dvec3(ray.direction))));
      const float through =
          point.transmission * shadow_transmittance(cosine, material.ior, material.thin);
      const auto way = static_cast<float>(point.front ? -t : t);
      solution.pass_glass(glm::vec3(point.base_color) * through,
                          material.thin ? glm::vec3(0.0f) : material.absorption * way);
    }
    if (real.blocked) return std::nullopt;
    // Once the mixed solution is dark, virtual objects make no difference any more.
    return virtual_only.blocked ? Visible::Real : Visible::Everything;
  };
  // Too many surfaces count as opaque.
  if (!walk_straight(scene, start, ray, Visible::Everything, pass)) real.blocked = true;
  const glm::vec3 real_attenuation = real.attenuation();
  return {real_attenuation * virtual_only.attenuation(), real_attenuation};
}

}  // namespace amalgam::trace
