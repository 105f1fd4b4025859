// The part that all specular surfaces share, and the spawning of child rays.
#include <algorithm>
#include <limits>

#include "trace/tile.h"

namespace amalgam::trace {
namespace {

float importance(const glm::vec3& weight) {
  return std::max({weight.x, weight.y, weight.z});
}

}  // namespace

void Tile::scatter(const RayItem& item, const MetSurface& met) {
  const glm::vec3 glow = light_weight(met.weight, item.media) * met.point.emission;
  paths_.samples[item.sample].mixed += glow;
  if (met.point.role == scene::Role::Real) paths_.samples[item.sample].real += glow;
  const glm::dvec3 normal =
      valid_shading_normal(met.point.geometric_normal, met.point.shading_normal, -item.direction);
  const scene::Material& material = this->material(met.point.material);
  if (material.kind == scene::MaterialKind::Mirror) {
    scatter_mirror(item, met, normal);
  } else if (material.thin) {
    scatter_thin(item, met, normal);
  } else {
    scatter_solid(item, met, normal);
  }
}

// Light that glass neither reflects nor transmits (transmission texture below 1) is scattered by
// its surface. This share is shaded as modelled and never looked up, because the camera sees the
// whole surface and not this share of it. A rough surface has no mirror image, so its share
// includes k_s.
void Tile::scatter_back(const RayItem& item, const MetSurface& met, float k_s) {
  const float share = is_rough(met.point) ? 1.0f : 1.0f - k_s;
  const glm::vec3 scattered = (1.0f - met.point.transmission) * share * met.weight;
  if (!(importance(scattered) > 0.0f)) return;
  diffuse_.push_back({met.point, -glm::vec3(item.direction), light_weight(scattered, item.media),
                      mean_channel(scattered), item.sample, RealColor::Modelled});
}

// Spawns a child ray. Beyond the depth limit or below the importance cut-off it takes the
// environment instead.
void Tile::spawn(const RayItem& parent, const MetSurface& met, const glm::dvec3& direction,
                 const glm::vec3& weight, RayKind kind, const Media& media) {
  const float share = importance(weight);
  if (!(share > 0.0f)) return;
  const bool deep = parent.depth + 1 > request_.settings.max_depth;
  if (deep || share < request_.settings.importance_cutoff) {
    escaped_.push_back({core::LightSource::CutOff, glm::vec3(direction), weight, parent.sample});
    return;
  }
  RayItem& child = waiting_.emplace_back();
  child.start = met.point.position;
  child.direction = direction;
  child.ray = {met.point.ray_origin(direction), glm::vec3(direction),
               std::numeric_limits<float>::infinity()};
  child.weight = weight;
  child.media = media;
  child.path_length = met.path_length;
  child.sample = parent.sample;
  child.depth = static_cast<std::uint16_t>(parent.depth + 1);
  child.kind = kind;
}

}  // namespace amalgam::trace
