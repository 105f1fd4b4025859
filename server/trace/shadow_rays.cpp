// Verbs: a shadow ray from each diffuse hit to each light that may reach it, and what it brings.
#include <glm/geometric.hpp>

#include "trace/shade.h"
#include "trace/shadow.h"
#include "trace/tile.h"

namespace amalgam::trace {

void Tile::spawn_shadow_rays() {
  radiance_.assign(diffuse_.size(), {});
  for (std::uint32_t d = 0; d < diffuse_.size(); ++d) {
    const DiffuseItem& item = diffuse_[d];
    const scene::Material& material = this->material(item.point.material);
    const scene::PhongTerms terms = phong_terms_at(item.point, material.kind);
    // What glows of glass was added where the ray met it.
    if (!scene::is_specular(material.kind))
      radiance_[d] = {item.point.emission, item.point.emission};
    for (const scene::Light& light : request_.lights) {
      const scene::LightArrival arrival =
          scene::light_arrival(light, glm::vec3(item.point.position));
      const glm::vec3 contribution = phong_contribution(terms, item.point, item.view, arrival);
      if (contribution == glm::vec3(0.0f)) continue;
      const glm::vec3 origin = item.point.ray_origin_on_line(glm::dvec3(arrival.to_light));
      shadows_.push_back(
          {item.point.position, {origin, arrival.to_light, arrival.distance}, contribution, d});
    }
  }
}

void Tile::trace_shadow_rays() {
  counts_.rays.shadow += shadows_.size();
  for (const ShadowItem& item : shadows_) {
    log(item.ray, request_.scene.anything_passes_light() ? RayQuery::All : RayQuery::Any);
    const ShadowAttenuation attenuation =
        trace_shadow(request_.scene, item.start, item.ray, passed_);
    radiance_[item.diffuse].mixed += item.contribution * attenuation.mixed;
    radiance_[item.diffuse].real += item.contribution * attenuation.real;
  }
}

}  // namespace amalgam::trace
