#include "scene/gltf/container.h"

#include <cstdint>
#include <string>

#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBin = 0x004E4942;

std::uint32_t u32(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;)
    value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
  return value;
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

GltfContainer open_gltf_container(std::span<const std::byte> file, bool must_be_glb) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  const bool has_magic = file.size() >= 4 && u32(file, 0) == kMagic;
  if (!has_magic && !must_be_glb) return {text_of(file), std::nullopt, false, file};
  if (!has_magic) throw SceneError("GLB does not begin with 'glTF'");
  if (file.size() < kHeader) throw SceneError("GLB ends inside its header");
  if (u32(file, 4) != 2) {
    throw SceneError("GLB version is " + std::to_string(u32(file, 4)) + "; only 2 is known");
  }
  const std::size_t declared = u32(file, 8);
  if (declared < kHeader || declared > file.size()) {
    throw SceneError("GLB declares " + std::to_string(u32(file, 8)) + " bytes and has " +
                     std::to_string(file.size()));
  }

  file = file.first(declared);  // bytes behind the end are nobody's

  GltfContainer container;
  container.is_glb = true;
  container.bytes = file;
  std::size_t at = kHeader;
  for (int chunk = 0; at < file.size(); ++chunk) {
    if (file.size() - at < kChunkHeader) throw SceneError("GLB ends inside a chunk header");
    const std::size_t length = u32(file, at);
    const std::uint32_t type = u32(file, at + 4);
    at += kChunkHeader;
    if (length > file.size() - at) throw SceneError("GLB ends inside a chunk");
    if (length % 4 != 0) throw SceneError("GLB chunk length is not a multiple of 4");
    const auto data = file.subspan(at, length);
    at += length;

    if ((chunk == 0) != (type == kJson)) {
      throw SceneError(chunk == 0 ? "GLB's first chunk is not JSON" : "GLB has two JSON chunks");
    }
    if (type == kBin) {
      if (chunk != 1) throw SceneError("GLB's BIN chunk is not the second, or there are two");
      container.binary = data;
    } else if (type == kJson) {
      container.json = text_of(data);
    }
  }
  if (container.json.empty()) throw SceneError("GLB has no JSON");
  return container;
}

}  // namespace amalgam::scene
