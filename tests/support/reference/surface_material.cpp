#include "support/reference/surface_material.h"

#include "support/reference/pictures.h"

namespace amalgam::reference {
namespace {

using scene::TextureSlot;

template <typename Value>
Value interpolate(const SurfacePlace& place, Value VertexAttributes::*attribute) {
  const auto& [a, b, c] = place.triangle.corners;
  const Vec3& weights = place.hit.weights;
  return weights.x * a.*attribute + weights.y * b.*attribute + weights.z * c.*attribute;
}

Vec2 texture_coordinates(const SurfacePlace& place, std::size_t set) {
  const auto& [a, b, c] = place.triangle.corners;
  const Vec3& weights = place.hit.weights;
  return weights.x * a.uvs[set] + weights.y * b.uvs[set] + weights.z * c.uvs[set];
}

// White where there is no texture: the factor then counts alone.
Vec4 read(const SurfacePlace& place, const std::optional<std::uint32_t>& texture, TextureSlot slot,
          TextureContent content) {
  if (!texture) return Vec4(1.0);
  const std::size_t set = place.material.reads_second_uvs(slot) ? 1 : 0;
  return sample_texture(place.textures[*texture], content, texture_coordinates(place, set),
                        place.triangle.uv_per_area[set] * place.hit.covered_area);
}

// glTF: the texel in [-1, 1], x and y scaled, in the frame of tangent, bitangent and normal. The
// tangent is made perpendicular to the normal there; the bitangent says only which way +y points.
Vec3 bent_by_texture(const SurfacePlace& place) {
  const Vec3& normal = place.hit.shading_normal;
  const Vec3 tangent = interpolate(place, &VertexAttributes::tangent);
  const Vec3 along = tangent - glm::dot(tangent, normal) * normal;
  if (glm::length(along) <= 1e-6 * glm::length(tangent)) return normal;
  const Vec3 x = glm::normalize(along);
  Vec3 y = glm::cross(normal, x);
  if (glm::dot(y, interpolate(place, &VertexAttributes::bitangent)) < 0.0) y = -y;

  const Vec4 texel =
      read(place, place.material.normal_texture, TextureSlot::Normal, TextureContent::Data);
  const double scale = static_cast<double>(place.material.normal_scale);
  const Vec3 bent = scale * (2.0 * texel.x - 1.0) * x + scale * (2.0 * texel.y - 1.0) * y +
                    (2.0 * texel.z - 1.0) * normal;
  const double length = glm::length(bent);
  return length > 0.0 ? bent / length : normal;
}

}  // namespace

Vec4 base_color(const SurfacePlace& place) {
  return Vec4(place.material.base_color) * interpolate(place, &VertexAttributes::color) *
         read(place, place.material.base_color_texture, TextureSlot::BaseColor,
              TextureContent::Color);
}

SurfaceMaterial surface_material(const SurfacePlace& place) {
  const scene::Material& material = place.material;
  const Vec4 emissive =
      read(place, material.emissive_texture, TextureSlot::Emissive, TextureContent::Color);
  const Vec4 metallic_roughness = read(place, material.metallic_roughness_texture,
                                       TextureSlot::MetallicRoughness, TextureContent::Data);
  const Vec4 transmission =
      read(place, material.transmission_texture, TextureSlot::Transmission, TextureContent::Data);
  return {.base_color = base_color(place),
          .emission = Color(material.emission) * Color(emissive),
          .metallic = static_cast<double>(material.metallic) * metallic_roughness.b,
          .roughness = static_cast<double>(material.roughness) * metallic_roughness.g,
          .transmission = static_cast<double>(material.transmission) * transmission.r,
          .normal = material.normal_texture ? bent_by_texture(place) : place.hit.shading_normal};
}

}  // namespace amalgam::reference
