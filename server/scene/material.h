// A surface's material, resolved from glTF into the three kinds that Amalgam renders.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>

namespace amalgam::scene {

enum class MaterialKind : std::uint8_t {
  Diffuse,     // Phong (eq. 4.6); rasterised
  Mirror,      // conductor: Schlick with F0 = base color (eq. 4.7); traced
  Dielectric,  // glass, water: reflects and refracts (eq. 4.7, 4.8); traced
};

constexpr bool is_specular(MaterialKind kind) {
  return kind != MaterialKind::Diffuse;
}

// The uses of a material's textures. Values are indices and bit numbers.
enum class TextureSlot : std::uint8_t {
  BaseColor,          // sRGB; multiplies base_color, alpha too
  MetallicRoughness,  // linear; B multiplies metallic, G roughness
  Emissive,           // sRGB; multiplies emission
  Transmission,       // linear; R multiplies transmission
  Normal,             // linear; tangent space, 2 rgb - 1
};
constexpr std::size_t kTextureSlots = 5;
constexpr std::array<TextureSlot, kTextureSlots> kAllTextureSlots{
    TextureSlot::BaseColor, TextureSlot::MetallicRoughness, TextureSlot::Emissive,
    TextureSlot::Transmission, TextureSlot::Normal};

// The greatest glTF roughness at which metals, and glass that scatters, show a mirror image.
constexpr float kSmoothRoughness = 0.2f;

struct Material {
  std::string name;
  MaterialKind kind = MaterialKind::Diffuse;

  glm::vec4 base_color{1.0f};  // linear RGB in [0,1], alpha

  // Indices into Scene::textures; see TextureSlot.
  std::optional<std::uint32_t> base_color_texture{};
  std::optional<std::uint32_t> metallic_roughness_texture{};
  std::optional<std::uint32_t> emissive_texture{};
  std::optional<std::uint32_t> transmission_texture{};
  std::optional<std::uint32_t> normal_texture{};
  float normal_scale = 1.0f;  // of the normal texture's x and y
  // Bit n: slot n is read at Mesh::second_uvs, not Mesh::uvs.
  std::uint32_t second_uv_slots = 0;

  glm::vec3 emission{0.0f};  // scene-linear radiance, strength included
  float metallic = 0.0f;     // [0,1]
  float roughness = 1.0f;    // [0,1], glTF's perceptual roughness
  bool double_sided = false;
  std::optional<float> alpha_cutoff{};  // set: alpha mode MASK

  // Dielectric only.
  // [0,1]: transmitted share of the light that is not reflected; the rest is scattered back
  // diffusely.
  float transmission = 1.0f;
  float ior = 1.5f;            // >= 1, relative to air; 0: infinite (a Mirror)
  bool thin = false;           // no volume: rays pass undeviated
  glm::vec3 absorption{0.0f};  // Beer-Lambert sigma_a, 1/m (0 = clear)

  std::optional<std::uint32_t> texture(TextureSlot slot) const;
  bool reads_second_uvs(TextureSlot slot) const {
    return (second_uv_slots >> static_cast<unsigned>(slot) & 1u) != 0;
  }
};

// Constants of the formulas below, also in shaders (gl/shader_constants.h).
constexpr float kDielectricF0 = 0.04f;  // glTF 2.0, appendix B: plastics and the like
constexpr float kMinSquaredAlpha = 1e-6f;
constexpr float kMaxPhongExponent = 1024.0f;

// Phong's terms (eq. 4.6) of a diffuse material. For irradiance E at cosine c > 0:
//   radiance = E c (albedo / pi + specular (exponent + 2) / (2 pi) max(R.V, 0)^exponent)
// The thesis's specular term has no cosine and no normalisation. With them the surface reflects no
// more than it receives (Lafortune and Willems 1994), as furnace tests need. glTF's roughness r
// becomes the exponent by matching highlight widths: alpha = r^2, Blinn-Phong exponent 2/alpha^2 -
// 2, Phong a quarter of it.
struct PhongTerms {
  glm::vec3 albedo{0.0f};
  glm::vec3 specular{0.0f};
  float exponent = 0.0f;  // [0, kMaxPhongExponent]
};

// Arguments: the material's factors times textures and vertex color at the point.
PhongTerms phong_terms(const glm::vec3& base_color, float metallic, float roughness);
// For a material without a metallic-roughness texture.
PhongTerms phong_terms(const Material& material, const glm::vec3& base_color);

// Schlick's R_m of a dielectric against air: ((n - 1) / (n + 1))^2.
float normal_reflectance(float ior);

}  // namespace amalgam::scene
