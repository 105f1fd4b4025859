// Verb: shades or scatters each hit of the batch (section 3 of the method).
#include <glm/exponential.hpp>

#include "trace/immersion.h"
#include "trace/tile.h"

namespace amalgam::trace {

void Tile::shade_hits() {
  for (std::size_t i = 0; i < batch_.size(); ++i) {
    const RayItem& item = batch_[i];
    const bool primary = item.kind == RayKind::Primary;
    if (!hits_[i]) {
      // A primary ray that misses draws nothing: the camera image stays.
      if (!primary)
        escaped_.push_back(
            {core::LightSource::Environment, glm::vec3(item.direction), item.weight, item.sample});
      continue;
    }
    const double path_length = item.path_length + hits_[i]->t;
    MetSurface met{
        surface_point(request_.scene, *hits_[i], item.direction, sample_spread_ * path_length),
        item.weight, path_length};
    const scene::Material& material = this->material(met.point.material);
    if (material.alpha_cutoff && met.point.base_color.w < *material.alpha_cutoff) {
      continue_through_cutout(item, met.point);
      continue;
    }
    if (const auto medium = item.media.innermost()) {  // Beer-Lambert on the way here
      const glm::vec3& absorption = this->material(*medium).absorption;
      if (absorption != glm::vec3(0.0f))
        met.weight *= glm::exp(-absorption * static_cast<float>(hits_[i]->t));
    }
    if (primary) count_primary(met.point, material);
    if (met.point.role == scene::Role::Virtual) paths_.samples[item.sample].met_virtual = true;
    if (scene::is_specular(material.kind)) {
      scatter(item, met);
      continue;
    }
    if (primary)
      paths_.samples[item.sample].sees_real_diffuse = met.point.role == scene::Role::Real;
    // Directly seen surfaces are not absorbed, because the rasteriser knows no media.
    const glm::vec3& share = primary ? item.weight : met.weight;
    diffuse_.push_back({met.point, -glm::vec3(item.direction), light_weight(share, item.media),
                        mean_channel(share), item.sample,
                        primary ? RealColor::UnderPixel : RealColor::LookedUp});
    if (primary) continue;
    const scene::PhongTerms terms = phong_terms_at(met.point, material.kind);
    if (const auto medium = item.media.innermost())
      diffuse_.back().mixed_gain = immersion_gain(terms, this->material(*medium).ior);
    if (const auto medium = item.media.innermost_real())
      diffuse_.back().real_gain = immersion_gain(terms, this->material(*medium).ior);
  }
}

void Tile::count_primary(const SurfacePoint& point, const scene::Material& material) {
  if (point.role == scene::Role::Virtual) ++counts_.primary_virtual;
  if (scene::is_specular(material.kind)) ++counts_.primary_specular;
}

// Alpha cut-out: the ray continues along the same line, with its depth and weight. Each step
// advances along it, so this ends.
void Tile::continue_through_cutout(const RayItem& item, const SurfacePoint& point) {
  RayItem next = item;
  next.ray.origin = point.ray_origin(item.direction);
  waiting_.push_back(next);
}

}  // namespace amalgam::trace
