#include "scene/gltf/materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "common/one_line.h"
#include "scene/gltf/check/limits.h"
#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

// tinygltf leaves a list empty that the file leaves out.
glm::dvec3 vec3_or(const std::vector<double>& numbers, double otherwise) {
  if (numbers.size() < 3) return glm::dvec3(otherwise);
  return {numbers[0], numbers[1], numbers[2]};
}

double number_or(const std::optional<JsonCursor>& object, const char* name, double otherwise) {
  const auto found = object ? object->find(name) : std::nullopt;
  return found ? found->number() : otherwise;
}

// sigma_a = -ln(attenuationColor) / attenuationDistance. A color of 0 would be infinite
// absorption: 1e-6 of the light over that distance is as black as a display can tell.
glm::vec3 absorption_of(const std::vector<double>& color, double distance) {
  constexpr double kBlack = 1e-6;
  glm::vec3 absorption(0.0f);
  for (int i = 0; i < 3; ++i) {
    const double c = std::clamp(color[static_cast<std::size_t>(i)], kBlack, 1.0);
    absorption[i] = static_cast<float>(std::min(-std::log(c) / distance, kMaxProduct));
  }
  return absorption;
}

void resolve_dielectric(const JsonCursor& extensions, Material& material) {
  material.kind = MaterialKind::Dielectric;
  const double ior = number_or(extensions.find("KHR_materials_ior"), "ior", 1.5);
  if (ior == 0.0) {
    // "Infinite" (KHR_materials_ior): reflects everything, whatever its color, as a white mirror.
    material.kind = MaterialKind::Mirror;
    material.base_color = glm::vec4(glm::vec3(1.0f), material.base_color.a);
    material.ior = 0.0f;
    return;
  }
  material.ior = static_cast<float>(std::max(ior, 1.0));
  const auto volume = extensions.find("KHR_materials_volume");
  material.thin = !(number_or(volume, "thicknessFactor", 0.0) > 0.0);
  const auto distance = volume ? volume->find("attenuationDistance") : std::nullopt;
  if (material.thin || !distance || distance->number() == 0.0) return;
  const auto color = volume->find("attenuationColor");
  material.absorption =
      absorption_of(color ? color->numbers(3) : std::vector<double>(3, 1.0), distance->number());
}

bool is_at_limit(const glm::vec3& products) {
  return glm::any(glm::equal(products, glm::vec3(static_cast<float>(kMaxProduct))));
}

void note_changes(const tinygltf::Material& from, const JsonCursor* at, const Material& material,
                  std::vector<std::string>& notes) {
  const auto note = [&](const std::string& what) {
    notes.push_back("material " + material.name + ": " + what);
  };
  if (from.alphaMode == "BLEND") {
    note(material.kind == MaterialKind::Dielectric
             ? "alpha blending ignored, drawn as glass"
             : "alpha blending is not supported, drawn opaque");
  }
  if (from.occlusionTexture.index >= 0) note("occlusion texture ignored");
  if (is_at_limit(material.emission)) note("its emission is brought to 1e12");
  if (is_at_limit(material.absorption)) note("its absorption is brought to 1e12 a metre");
  const auto extensions = at ? at->find("extensions") : std::nullopt;
  if (!extensions) return;
  constexpr std::array<std::string_view, 4> kUsed{"KHR_materials_transmission", "KHR_materials_ior",
                                                  "KHR_materials_volume",
                                                  "KHR_materials_emissive_strength"};
  for (const auto& [extension, content] : extensions->members()) {
    if (std::find(kUsed.begin(), kUsed.end(), extension) == kUsed.end()) {
      note(extension + " ignored");
    } else if (content.find("thicknessTexture")) {
      note("thickness texture ignored, rays find their own way");
    }
  }
}

Material resolve_material(const tinygltf::Material& from, const JsonCursor* at) {
  constexpr double kTransmissive = 0.5, kMetallic = 0.5;
  Material material;
  material.name = common::one_line(from.name);
  const auto& pbr = from.pbrMetallicRoughness;
  const auto& factor = pbr.baseColorFactor;
  material.base_color =
      glm::vec4(vec3_or(factor, 1.0), factor.size() < 4 ? 1.0f : static_cast<float>(factor[3]));
  // The check lets pass what is a hair outside.
  material.base_color = glm::clamp(material.base_color, 0.0f, 1.0f);
  material.metallic = std::clamp(static_cast<float>(pbr.metallicFactor), 0.0f, 1.0f);
  material.roughness = std::clamp(static_cast<float>(pbr.roughnessFactor), 0.0f, 1.0f);
  material.double_sided = from.doubleSided;
  if (from.alphaMode == "MASK") material.alpha_cutoff = static_cast<float>(from.alphaCutoff);

  const auto extensions = at ? at->find("extensions") : std::nullopt;
  const auto extension = [&](const char* name) {
    return extensions ? extensions->find(name) : std::nullopt;
  };
  const double strength =
      number_or(extension("KHR_materials_emissive_strength"), "emissiveStrength", 1.0);
  material.emission =
      glm::vec3(glm::clamp(vec3_or(from.emissiveFactor, 0.0) * strength, 0.0, kMaxProduct));

  const double transmission =
      number_or(extension("KHR_materials_transmission"), "transmissionFactor", 0.0);
  if (transmission >= kTransmissive) {
    material.transmission = std::min(static_cast<float>(transmission), 1.0f);
    resolve_dielectric(*extensions, material);
  } else if (pbr.metallicFactor >= kMetallic && material.roughness <= kSmoothRoughness) {
    material.kind = MaterialKind::Mirror;
  }
  return material;
}

// Gives a material its textures, and the meshes that wear it their texture coordinates.
class TextureAssigner {
 public:
  TextureAssigner(TextureLoader& loader, Material& material, std::vector<TextureUse>& uses,
                  std::vector<std::string>& notes)
      : loader_(loader), material_(material), uses_(uses), notes_(notes) {}

  void assign_all(const tinygltf::Material& from) {
    using enum TextureSlot;
    const auto& pbr = from.pbrMetallicRoughness;
    const bool diffuse = material_.kind == MaterialKind::Diffuse;
    const bool glass = material_.kind == MaterialKind::Dielectric;
    // Infinite: its color does not matter.
    const bool reflects_all = !diffuse && material_.ior == 0.0f;
    if (!reflects_all) assign(BaseColor, pbr.baseColorTexture, TexelEncoding::Srgb);
    if (material_.emission != glm::vec3(0.0f))
      assign(Emissive, from.emissiveTexture, TexelEncoding::Srgb);
    if (glass) assign_transmission(from);
    // Mirrors and what goes through glass are smooth, whatever a texture says of single points.
    const bool scatters =
        glass && (material_.transmission < 1.0f || material_.transmission_texture);
    if (diffuse || scatters)
      assign(MetallicRoughness, pbr.metallicRoughnessTexture, TexelEncoding::Linear);
    assign(Normal, from.normalTexture, TexelEncoding::Linear);
    material_.normal_scale = static_cast<float>(from.normalTexture.scale);
  }

 private:
  std::optional<std::uint32_t>& texture(TextureSlot slot) {
    switch (slot) {
      case TextureSlot::MetallicRoughness:
        return material_.metallic_roughness_texture;
      case TextureSlot::Emissive:
        return material_.emissive_texture;
      case TextureSlot::Transmission:
        return material_.transmission_texture;
      case TextureSlot::Normal:
        return material_.normal_texture;
      case TextureSlot::BaseColor:
        break;
    }
    return material_.base_color_texture;
  }

  template <typename Info>
  TextureUse use_of(const Info& info) const {
    try {
      return texture_use(info.texCoord, info.extensions);
    } catch (const SceneError& caught) {
      throw SceneError("material " + material_.name + ": " + caught.what());
    }
  }

  // tinygltf has a type for each kind of texture, and all say this much.
  template <typename Info>
  void assign(TextureSlot slot, const Info& info, TexelEncoding encoding) {
    if (info.index < 0) return;
    const auto use = place(use_of(info));
    if (!use) return note("a texture with a third set of coordinates is ignored");
    texture(slot) = loader_.load(info.index, encoding);
    if (!texture(slot)) return note("its texture has no picture");
    if (*use == 1) material_.second_uv_slots |= 1u << static_cast<unsigned>(slot);
  }

  void assign_transmission(const tinygltf::Material& from) {
    const auto extension = from.extensions.find("KHR_materials_transmission");
    if (extension == from.extensions.end() || !extension->second.Has("transmissionTexture")) return;
    tinygltf::TextureInfo info;
    const tinygltf::Value& value = extension->second.Get("transmissionTexture");
    info.index = value.Get("index").GetNumberAsInt();
    if (value.Has("texCoord")) info.texCoord = value.Get("texCoord").GetNumberAsInt();
    if (value.Has("extensions")) {
      const tinygltf::Value& inner = value.Get("extensions");
      for (const std::string& name : inner.Keys()) info.extensions[name] = inner.Get(name);
    }
    assign(TextureSlot::Transmission, info, TexelEncoding::Linear);
  }

  // 0 or 1: the mesh's first or second coordinates.
  std::optional<std::size_t> place(const TextureUse& use) {
    const auto found = std::find(uses_.begin(), uses_.end(), use);
    const auto index = static_cast<std::size_t>(found - uses_.begin());
    if (found == uses_.end()) {
      if (uses_.size() == 2) return std::nullopt;
      uses_.push_back(use);
    }
    return index;
  }

  void note(const char* what) { notes_.push_back("material " + material_.name + ": " + what); }

  TextureLoader& loader_;
  Material& material_;
  std::vector<TextureUse>& uses_;
  std::vector<std::string>& notes_;
};

}  // namespace

ResolvedMaterials resolve_materials(const GltfModel& gltf, std::vector<Texture>& textures,
                                    std::vector<std::string>& notes) {
  ResolvedMaterials resolved;
  TextureLoader loader(gltf.model, textures);
  const auto at = JsonCursor(gltf.document).find("materials");
  const auto cursors = at ? at->items() : std::vector<JsonCursor>{};
  for (std::size_t i = 0; i < gltf.model.materials.size(); ++i) {
    const tinygltf::Material& from = gltf.model.materials[i];
    Material material = resolve_material(from, &cursors[i]);
    if (material.name.empty()) material.name = "materials[" + std::to_string(i) + "]";
    note_changes(from, &cursors[i], material, notes);
    TextureAssigner(loader, material, resolved.texture_uses.emplace_back(), notes).assign_all(from);
    resolved.materials.push_back(std::move(material));
  }
  Material fallback = resolve_material(tinygltf::Material(), nullptr);
  fallback.name = "default";
  resolved.materials.push_back(std::move(fallback));
  resolved.texture_uses.emplace_back();
  return resolved;
}

}  // namespace amalgam::scene
