#include "scene/gltf/textures.h"

#include <span>
#include <string>

#include "codec/picture.h"
#include "scene/gltf/check/limits.h"
#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

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

}  // namespace

std::optional<std::uint32_t> TextureLoader::load(int index, TexelEncoding encoding) {
  const auto found = loaded_.find({index, encoding});
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
  texels_ += texture.texels.pixels().size();
  if (texels_ > kMaxTexels) throw SceneError("textures together are larger than 128 Mpixel");
  if (from.sampler >= 0) {
    const auto& sampler = model_.samplers[static_cast<std::size_t>(from.sampler)];
    texture.wrap_u = wrap_of(sampler.wrapS);
    texture.wrap_v = wrap_of(sampler.wrapT);
  }
  texture.mips = make_mips(texture.texels, encoding);
  const auto id = static_cast<std::uint32_t>(textures_.size());
  textures_.push_back(std::move(texture));
  loaded_.emplace(std::pair(index, encoding), id);
  return id;
}

TextureUse texture_use(int uv_set, const tinygltf::ExtensionMap& extensions) {
  TextureUse use;
  use.uv_set = uv_set;
  const auto extension = extensions.find("KHR_texture_transform");
  if (extension == extensions.end()) return use;
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

}  // namespace amalgam::scene
