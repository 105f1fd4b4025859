#include "trace/texels.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "scene/texture_lookup.h"
#include "trace/interpolate.h"

namespace amalgam::trace {

using scene::TextureSlot;

Texels::Texels(const scene::Scene& scene, const Hit& hit, const TexelFootprint& footprint)
    : scene_(scene),
      mesh_(scene.meshes[scene.instances[hit.instance].mesh]),
      material_(scene.materials[scene.instances[hit.instance].material]),
      corners_(mesh_.triangles[hit.triangle]),
      barycentric_(hit.barycentric),
      footprint_(footprint) {}

glm::vec4 Texels::sample(TextureSlot slot) const {
  const auto& uvs = scene::uvs_of(mesh_, material_, slot);
  const scene::Texture& texture = scene_.textures[*material_.texture(slot)];
  const float ratio = footprint_.cone_width > 0.0f ? scene::uv_area_ratio(mesh_, uvs, corners_) /
                                                         footprint_.world_area_per_mesh_area
                                                   : 0.0f;
  const float footprint = scene::uv_footprint(ratio, footprint_.cone_width, footprint_.cosine);
  const glm::vec2 uv = interpolate(uvs, corners_, barycentric_);
  const bool color = slot == TextureSlot::BaseColor || slot == TextureSlot::Emissive;
  return color ? scene::sample_color_texture(texture, uv, footprint)
               : scene::sample_data_texture(texture, uv, footprint);
}

glm::vec4 Texels::base_color() const {
  glm::vec4 color = material_.base_color;
  if (!mesh_.colors.empty()) color *= interpolate(mesh_.colors, corners_, barycentric_);
  if (has(TextureSlot::BaseColor)) color *= sample(TextureSlot::BaseColor);
  return color;
}

glm::vec3 Texels::emission() const {
  if (!has(TextureSlot::Emissive)) return material_.emission;
  return material_.emission * glm::vec3(sample(TextureSlot::Emissive));
}

glm::vec2 Texels::metallic_roughness() const {
  const glm::vec2 factors(material_.metallic, material_.roughness);
  if (!has(TextureSlot::MetallicRoughness)) return factors;
  const glm::vec4 texel = sample(TextureSlot::MetallicRoughness);
  return factors * glm::vec2(texel.b, texel.g);
}

float Texels::transmission() const {
  if (!has(TextureSlot::Transmission)) return material_.transmission;
  return material_.transmission * sample(TextureSlot::Transmission).r;
}

glm::dvec3 Texels::bent_normal(const glm::dvec3& normal, const PlacedInstance& placed) const {
  if (!has(TextureSlot::Normal) || mesh_.tangents.empty()) return normal;
  const glm::vec4 tangent = interpolate(mesh_.tangents, corners_, barycentric_);
  const glm::dmat3 linear(placed.world_from_mesh);
  const glm::dvec3 along = linear * glm::dvec3(tangent);
  const glm::dvec3 flat = along - glm::dot(along, normal) * normal;
  const double length = glm::length(flat);
  if (!(length > scene::kMinTangentShare * glm::length(along))) return normal;
  const glm::dvec3 x = flat / length;
  // A mirroring transform keeps the normal outward, which reverses the cross product.
  const double mirrored = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
  const glm::dvec3 y = glm::cross(normal, x) * (tangent.w < 0.0f ? -mirrored : mirrored);
  const glm::dvec3 texel = 2.0 * glm::dvec3(sample(TextureSlot::Normal)) - 1.0;
  const double scale = material_.normal_scale;
  const glm::dvec3 bent = texel.x * scale * x + texel.y * scale * y + texel.z * normal;
  const double bent_length = glm::length(bent);
  return bent_length > 0.0 ? bent / bent_length : normal;
}

}  // namespace amalgam::trace
