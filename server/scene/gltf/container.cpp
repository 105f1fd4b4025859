#include "scene/gltf/container.h"

#include <algorithm>
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

constexpr std::size_t kHeader = 12, kChunkHeader = 8;

// A chunk whose length is no multiple of 4 should be padded; some writers do not, or do not count
// the padding. Where the next chunk begins shows by its type.
std::size_t next_chunk(std::span<const std::byte> file, std::size_t end,
                       std::vector<std::string>& notes) {
  const std::size_t padded = (end + 3) / 4 * 4;
  if (padded == end) return end;
  notes.emplace_back("GLB chunk length is not a multiple of 4");
  const bool follows_at_once = file.size() >= end + kChunkHeader && u32(file, end + 4) == kBin;
  return follows_at_once ? end : std::min(padded, file.size());
}

}  // namespace

GltfContainer open_gltf_container(std::span<const std::byte> file, bool must_be_glb,
                                  std::vector<std::string>& notes) {
  const bool has_magic = file.size() >= 4 && u32(file, 0) == kMagic;
  if (!has_magic && !must_be_glb) return {text_of(file), std::nullopt};
  if (!has_magic) throw SceneError("GLB does not begin with 'glTF'");
  if (file.size() < kHeader) throw SceneError("GLB ends inside its header");
  if (u32(file, 4) != 2) {
    throw SceneError("GLB version is " + std::to_string(u32(file, 4)) + "; only 2 is known");
  }
  const std::size_t declared = u32(file, 8);
  const std::string sizes =
      "GLB declares " + std::to_string(declared) + " bytes and has " + std::to_string(file.size());
  if (declared > file.size()) throw SceneError(sizes);
  if (declared < file.size()) notes.push_back(sizes);
  GltfContainer container;
  std::size_t at = kHeader;
  for (int chunk = 0; at < file.size(); ++chunk) {
    // Behind the declared end only what the first two chunks need is read.
    if (file.size() - at < kChunkHeader || (at >= declared && chunk >= 2)) {
      notes.push_back("GLB has " + std::to_string(file.size() - at) +
                      " bytes behind its last chunk");
      break;
    }
    const std::size_t length = u32(file, at);
    const std::uint32_t type = u32(file, at + 4);
    at += kChunkHeader;
    if (length > file.size() - at) throw SceneError("GLB ends inside a chunk");
    const auto data = file.subspan(at, length);
    at = next_chunk(file, at + length, notes);

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
