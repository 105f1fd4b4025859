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
    radiance_[d] = emitted(diffuse_[d]);
    spawn_shadow_rays(d, diffuse_[d].only_change_counts() ? request_.virtual_shadows : nullptr);
  }
}

DiffuseRadiance Tile::emitted(const DiffuseItem& item) const {
  // The emission of glass was added when the ray met it.
  const bool emits =
      !request_.white_surfaces && !scene::is_specular(material(item.point.material).kind);
  if (!emits) return {};
  return {item.point.emission * item.mixed_gain, item.point.emission * item.real_gain};
}

// bound: leaves out rays to lights that no virtual object occludes; null: none.
void Tile::spawn_shadow_rays(std::uint32_t d, const ShadowBound* bound) {
  const SurfacePoint& point = diffuse_[d].point;
  const glm::vec3 position(point.position);
  for (std::size_t light = 0; light < request_.lights.size(); ++light) {
    if (bound != nullptr && !bound->may_be_shaded(light, position)) continue;
    const scene::LightArrival arrival = scene::light_arrival(request_.lights[light], position);
    if (arrival.irradiance == glm::vec3(0.0f) || !is_lit_from(point, arrival.to_light)) continue;
    const glm::vec3 origin = point.ray_origin_on_line(glm::dvec3(arrival.to_light));
    const float t_max = arrival.distance + static_cast<float>(point.offset);
    shadows_.push_back({point.position, {origin, arrival.to_light, t_max}, arrival.irradiance, d});
  }
}

void Tile::trace_shadow_rays() {
  changed_.assign(diffuse_.size(), 0);
  for (const ShadowItem& shadow : shadows_) {
    const bool only_change = diffuse_[shadow.diffuse].only_change_counts();
    const ShadowAttenuation attenuation = trace_shadow_ray(shadow, only_change);
    if (only_change && !attenuation.differs()) continue;
    changed_[shadow.diffuse] = only_change ? 1 : 0;
    add_light(shadow, attenuation);
  }
  counts_.rays.shadow += shadows_.size();
  if (request_.real_surfaces == scene::RealSurfaces::Ratio) shade_changed_in_full();
}

// A ratio needs the light of all lights, also of those that virtual objects do not change. But few
// surfaces in mirrors and behind glass lie in a virtual shadow, so only these are shaded in full.
void Tile::shade_changed_in_full() {
  shadows_.clear();
  for (std::uint32_t d = 0; d < diffuse_.size(); ++d) {
    if (changed_[d] == 0) continue;
    radiance_[d] = emitted(diffuse_[d]);
    spawn_shadow_rays(d, nullptr);
  }
  for (const ShadowItem& shadow : shadows_) add_light(shadow, trace_shadow_ray(shadow, false));
  counts_.rays.shadow += shadows_.size();
}

// only_change: both attenuations are 1 if no virtual object changes the light.
ShadowAttenuation Tile::trace_shadow_ray(const ShadowItem& shadow, bool only_change) {
  // As it leaves the surface: for measuring, which knows of no surface to leave behind.
  Ray leaving = shadow.ray;
  leaving.t_min = 2.0f * static_cast<float>(diffuse_[shadow.diffuse].point.offset);
  log(leaving, only_change ? Visible::Virtual : Visible::Everything,
      request_.scene.anything_passes_light() ? RayQuery::All : RayQuery::Any);
  const auto trace = only_change ? trace_shadow_change : trace_shadow;
  return trace(request_.scene, shadow.start, shadow.ray, passed_);
}

void Tile::add_light(const ShadowItem& shadow, const ShadowAttenuation& attenuation) {
  constexpr scene::PhongTerms kWhite{
      .albedo = glm::vec3(1.0f), .specular = glm::vec3(0.0f), .exponent = 1.0f};
  const DiffuseItem& item = diffuse_[shadow.diffuse];
  const scene::PhongTerms terms =
      request_.white_surfaces ? kWhite
                              : phong_terms_at(item.point, material(item.point.material).kind);
  const glm::vec3 contribution =
      phong_contribution(terms, item.point, item.view, shadow.ray.direction, shadow.irradiance);
  radiance_[shadow.diffuse].mixed += contribution * (item.mixed_gain * attenuation.mixed);
  radiance_[shadow.diffuse].real += contribution * (item.real_gain * attenuation.real);
}

}  // namespace amalgam::trace
