#include "scene/material.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace amalgam::scene {

std::optional<std::uint32_t> Material::texture(TextureSlot slot) const {
  switch (slot) {
    case TextureSlot::BaseColor:
      return base_color_texture;
    case TextureSlot::MetallicRoughness:
      return metallic_roughness_texture;
    case TextureSlot::Emissive:
      return emissive_texture;
    case TextureSlot::Transmission:
      return transmission_texture;
    case TextureSlot::Normal:
      return normal_texture;
  }
  return std::nullopt;
}

PhongTerms phong_terms(const Material& material, const glm::vec3& base_color) {
  return phong_terms(base_color, material.metallic, material.roughness);
}

PhongTerms phong_terms(const glm::vec3& base_color, float metallic, float roughness) {
  const float alpha = roughness * roughness;
  PhongTerms terms;
  terms.specular = glm::mix(glm::vec3(kDielectricF0), base_color, metallic);
  terms.albedo = base_color * (1.0f - metallic) * (1.0f - kDielectricF0);
  terms.exponent =
      std::clamp(0.5f / std::max(alpha * alpha, kMinSquaredAlpha) - 0.5f, 0.0f, kMaxPhongExponent);
  return terms;
}

float normal_reflectance(float ior) {
  const float ratio = (ior - 1.0f) / (ior + 1.0f);
  return ratio * ratio;
}

}  // namespace amalgam::scene
