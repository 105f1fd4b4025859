// glTF textures: decodes their pictures once, and reads how a material places them on a surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "scene/gltf/model.h"
#include "scene/mip_chain.h"
#include "scene/scene.h"

namespace amalgam::scene {

// The texture coordinates that a texture reads, and its KHR_texture_transform, which is applied to
// them when the mesh is read.
struct TextureUse {
  int uv_set = 0;  // n of TEXCOORD_n
  glm::vec2 offset{0.0f};
  glm::vec2 scale{1.0f};
  float rotation = 0.0f;  // radians, counter-clockwise

  bool operator==(const TextureUse&) const = default;
};

// extensions: those of a tinygltf::TextureInfo or the like. Throws SceneError.
TextureUse texture_use(int uv_set, const tinygltf::ExtensionMap& extensions);

// Loads each texture at most once for each encoding, with its mips. Samplers' filter modes are
// ignored: all textures are filtered trilinearly.
class TextureLoader {
 public:
  TextureLoader(const tinygltf::Model& model, std::vector<Texture>& textures)
      : model_(model), textures_(textures) {}

  // Index into the textures; nothing if the texture has no picture. Throws SceneError if the
  // picture cannot be read.
  std::optional<std::uint32_t> load(int index, TexelEncoding encoding);

 private:
  const tinygltf::Model& model_;
  std::vector<Texture>& textures_;
  std::map<std::pair<int, TexelEncoding>, std::uint32_t> loaded_;
  std::size_t texels_ = 0;
};

}  // namespace amalgam::scene
