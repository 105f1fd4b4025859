// Verbs: spawn a shadow ray from each diffuse hit to each light that may reach it, trace it, and
// add the light's contribution.
#include <glm/geometric.hpp>

#include "trace/shade.h"
#include "trace/shadow.h"
#include "trace/tile.h"

namespace amalgam::trace {

void Tile::spawn_shadow_rays() {
  radiance_.assign(diffuse_.size(), {});
  for (std::uint32_t d = 0; d < diffuse_.size(); ++d) {
    const SurfacePoint& point = diffuse_[d].point;
    // The emission of glass was added when the ray met it.
    if (!scene::is_specular(material(point.material).kind))
      radiance_[d] = {point.emission * diffuse_[d].mixed_gain,
                      point.emission * diffuse_[d].real_gain};
    const ShadowBound* bound =
        diffuse_[d].only_change_counts() ? request_.virtual_shadows : nullptr;
    const glm::vec3 position(point.position);
    for (std::size_t light = 0; light < request_.lights.size(); ++light) {
      if (bound != nullptr && !bound->may_be_shaded(light, position)) continue;
      const scene::LightArrival arrival = scene::light_arrival(request_.lights[light], position);
      if (arrival.irradiance == glm::vec3(0.0f) || !is_lit_from(point, arrival.to_light)) continue;
      const glm::vec3 origin = point.ray_origin_on_line(glm::dvec3(arrival.to_light));
      const float t_max = arrival.distance + static_cast<float>(point.offset);
      shadows_.push_back(
          {point.position, {origin, arrival.to_light, t_max}, arrival.irradiance, d});
    }
  }
}

void Tile::trace_shadow_rays() {
  counts_.rays.shadow += shadows_.size();
  for (const ShadowItem& shadow : shadows_) {
    const DiffuseItem& item = diffuse_[shadow.diffuse];
    const bool only_change = item.only_change_counts();
    // As it leaves the surface: for measuring, which knows of no surface to leave behind.
    Ray leaving = shadow.ray;
    leaving.t_min = 2.0f * static_cast<float>(item.point.offset);
    log(leaving, only_change ? Visible::Virtual : Visible::Everything,
        request_.scene.anything_passes_light() ? RayQuery::All : RayQuery::Any);
    const auto trace = only_change ? trace_shadow_change : trace_shadow;
    const ShadowAttenuation attenuation = trace(request_.scene, shadow.start, shadow.ray, passed_);
    if (only_change && !attenuation.differs()) continue;
    const scene::PhongTerms terms = phong_terms_at(item.point, material(item.point.material).kind);
    const glm::vec3 contribution =
        phong_contribution(terms, item.point, item.view, shadow.ray.direction, shadow.irradiance);
    radiance_[shadow.diffuse].mixed += contribution * (item.mixed_gain * attenuation.mixed);
    radiance_[shadow.diffuse].real += contribution * (item.real_gain * attenuation.real);
  }
}

}  // namespace amalgam::trace
