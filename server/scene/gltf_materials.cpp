#include "scene/gltf_materials.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "codec/picture.h"
#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

// tinygltf leaves a list empty that the file leaves out.
glm::vec3 vec3_or(const std::vector<double>& numbers, float otherwise) {
  if (numbers.size() < 3) return glm::vec3(otherwise);
  return {static_cast<float>(numbers[0]), static_cast<float>(numbers[1]),
          static_cast<float>(numbers[2])};
}

Wrap wrap_of(int mode) {
  switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return Wrap::Clamp;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return Wrap::Mirror;
    default:
      return Wrap::Repeat;
  }
}

// Loads each texture at most once.
class TextureLoader {
 public:
  TextureLoader(const tinygltf::Model& model, std::vector<Texture>& textures)
      : model_(model), textures_(textures) {}

  // Nothing if the texture names no picture that can be read.
  std::optional<std::uint32_t> load(int index) {
    const auto found = loaded_.find(index);
    if (found != loaded_.end()) return found->second;
    const tinygltf::Texture& from = model_.textures[static_cast<std::size_t>(index)];
    if (from.source < 0) return std::nullopt;
    Texture texture;
    try {
      const auto& encoded = model_.images[static_cast<std::size_t>(from.source)].image;
      texture.texels = codec::decode_picture(std::as_bytes(std::span(encoded)));
    } catch (const codec::PictureError& caught) {
      throw SceneError("images[" + std::to_string(from.source) + "]: " + caught.what());
    }
    constexpr std::size_t kMaxTexels = std::size_t{128} << 20;
    texels_ += texture.texels.pixels().size();
    if (texels_ > kMaxTexels) throw SceneError("textures together are larger than 128 Mpixel");
    if (from.sampler >= 0) {
      const auto& sampler = model_.samplers[static_cast<std::size_t>(from.sampler)];
      texture.wrap_u = wrap_of(sampler.wrapS);
      texture.wrap_v = wrap_of(sampler.wrapT);
    }
    const auto id = static_cast<std::uint32_t>(textures_.size());
    textures_.push_back(std::move(texture));
    loaded_.emplace(index, id);
    return id;
  }

 private:
  const tinygltf::Model& model_;
  std::vector<Texture>& textures_;
  std::map<int, std::uint32_t> loaded_;
  std::size_t texels_ = 0;
};

TextureUse texture_use(const tinygltf::TextureInfo& info) {
  TextureUse use;
  use.uv_set = info.texCoord;
  const auto extension = info.extensions.find("KHR_texture_transform");
  if (extension == info.extensions.end()) return use;
  const tinygltf::Value& value = extension->second;
  const auto pair_of = [&](const char* name, const glm::vec2& otherwise) {
    if (!value.Has(name)) return otherwise;
    const tinygltf::Value& list = value.Get(name);
    if (!list.IsArray() || list.ArrayLen() != 2 || !list.Get(0).IsNumber() ||
        !list.Get(1).IsNumber()) {
      throw SceneError(std::string("KHR_texture_transform.") + name + ": expected 2 numbers");
    }
    return glm::vec2(static_cast<float>(list.Get(0).GetNumberAsDouble()),
                     static_cast<float>(list.Get(1).GetNumberAsDouble()));
  };
  use.offset = pair_of("offset", use.offset);
  use.scale = pair_of("scale", use.scale);
  if (value.Has("rotation") && value.Get("rotation").IsNumber()) {
    use.rotation = static_cast<float>(value.Get("rotation").GetNumberAsDouble());
  }
  if (value.Has("texCoord") && value.Get("texCoord").IsInt()) {
    use.uv_set = value.Get("texCoord").GetNumberAsInt();
  }
  return use;
}

double number_or(const std::optional<JsonCursor>& object, const char* name, double otherwise) {
  const auto found = object ? object->find(name) : std::nullopt;
  return found ? found->number() : otherwise;
}

// sigma_a = -ln(attenuationColor) / attenuationDistance. A colour of 0 would be infinite
// absorption: 1e-6 of the light over that distance is as black as a display can tell.
glm::vec3 absorption_of(const std::vector<double>& color, double distance) {
  constexpr double kBlack = 1e-6;
  glm::vec3 absorption(0.0f);
  for (int i = 0; i < 3; ++i) {
    const double c = std::clamp(color[static_cast<std::size_t>(i)], kBlack, 1.0);
    absorption[i] = static_cast<float>(-std::log(c) / distance);
  }
  return absorption;
}

void resolve_dielectric(const JsonCursor& extensions, Material& material) {
  material.kind = MaterialKind::Dielectric;
  const double ior = number_or(extensions.find("KHR_materials_ior"), "ior", 1.5);
  // The specification's 0 stands for "infinite"; the highest index in nature is about 4.
  material.ior = ior == 0.0 ? 100.0f : static_cast<float>(std::max(ior, 1.0));
  const auto volume = extensions.find("KHR_materials_volume");
  material.thin = !(number_or(volume, "thicknessFactor", 0.0) > 0.0);
  const auto distance = volume ? volume->find("attenuationDistance") : std::nullopt;
  if (material.thin || !distance) return;
  const auto color = volume->find("attenuationColor");
  material.absorption =
      absorption_of(color ? color->numbers(3) : std::vector<double>(3, 1.0), distance->number());
}

void note_unused(const tinygltf::Material& from, const JsonCursor* at,
                 std::vector<std::string>& notes, const std::string& name) {
  const auto note = [&](const char* what) { notes.push_back("material " + name + ": " + what); };
  if (from.alphaMode == "BLEND") note("alpha blending is not supported, drawn opaque");
  if (from.normalTexture.index >= 0) note("normal texture ignored");
  if (from.emissiveTexture.index >= 0) note("emissive texture ignored");
  if (from.pbrMetallicRoughness.metallicRoughnessTexture.index >= 0) {
    note("metallic-roughness texture ignored, its factors used");
  }
  const auto extensions = at ? at->find("extensions") : std::nullopt;
  if (!extensions) return;
  constexpr std::array<std::string_view, 8> kUsed{"KHR_materials_transmission", "KHR_materials_ior",
                                                  "KHR_materials_volume",
                                                  "KHR_materials_emissive_strength"};
  for (const auto& [extension, content] : extensions->members()) {
    if (std::find(kUsed.begin(), kUsed.end(), extension) == kUsed.end()) {
      note((extension + " ignored").c_str());
    } else if (content.find("transmissionTexture") || content.find("thicknessTexture")) {
      note((extension + ": its texture ignored, its factor used").c_str());
    }
  }
}

Material resolve_material(const tinygltf::Material& from, const JsonCursor* at) {
  constexpr double kTransmissive = 0.5, kMetallic = 0.5, kSmooth = 0.2;
  Material material;
  material.name = from.name;
  const auto& pbr = from.pbrMetallicRoughness;
  const auto& factor = pbr.baseColorFactor;
  material.base_color =
      glm::vec4(vec3_or(factor, 1.0f), factor.size() < 4 ? 1.0f : static_cast<float>(factor[3]));
  material.metallic = static_cast<float>(pbr.metallicFactor);
  material.roughness = static_cast<float>(pbr.roughnessFactor);
  material.double_sided = from.doubleSided;
  if (from.alphaMode == "MASK") material.alpha_cutoff = static_cast<float>(from.alphaCutoff);

  const auto extensions = at ? at->find("extensions") : std::nullopt;
  const auto extension = [&](const char* name) {
    return extensions ? extensions->find(name) : std::nullopt;
  };
  const double strength =
      number_or(extension("KHR_materials_emissive_strength"), "emissiveStrength", 1.0);
  material.emission = vec3_or(from.emissiveFactor, 0.0f) * static_cast<float>(strength);

  if (number_or(extension("KHR_materials_transmission"), "transmissionFactor", 0.0) >=
      kTransmissive) {
    resolve_dielectric(*extensions, material);
  } else if (pbr.metallicFactor >= kMetallic && pbr.roughnessFactor <= kSmooth) {
    material.kind = MaterialKind::Mirror;
  }
  return material;
}

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
    note_unused(from, &cursors[i], notes, material.name);
    const auto& info = from.pbrMetallicRoughness.baseColorTexture;
    if (info.index >= 0) {
      material.base_color_texture = loader.load(info.index);
      if (!material.base_color_texture)
        notes.push_back("material " + material.name + ": its texture has no picture");
    }
    resolved.materials.push_back(std::move(material));
    resolved.texture_uses.push_back(texture_use(info));
  }
  Material fallback = resolve_material(tinygltf::Material(), nullptr);
  fallback.name = "default";
  resolved.materials.push_back(std::move(fallback));
  resolved.texture_uses.emplace_back();
  return resolved;
}

}  // namespace amalgam::scene
