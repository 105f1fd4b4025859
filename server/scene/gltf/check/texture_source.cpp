#include "scene/gltf/check/texture_source.h"

namespace amalgam::scene {

std::optional<std::size_t> texture_source(const JsonCursor& texture) {
  const auto extensions = texture.find("extensions");
  const auto extension = [&](const char* name) {
    return extensions ? extensions->find(name) : std::nullopt;
  };
  auto source = texture.find("source");
  if (const auto webp = extension("EXT_texture_webp")) {
    if (const auto other = webp->find("source")) source = other;
  }
  if (source) return static_cast<std::size_t>(source->integer(0));
  if (const auto basis = extension("KHR_texture_basisu")) {
    basis->fail(
        "Basis Universal textures are not supported; convert the file with 'npx "
        "@gltf-transform/cli ktxdecompress IN.glb OUT.glb'");
  }
  return std::nullopt;
}

}  // namespace amalgam::scene
