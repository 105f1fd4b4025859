// The container of a glTF file: plain JSON (.gltf), or JSON and one binary buffer in chunks (.glb).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace amalgam::scene {

struct GltfContainer {
  std::string_view json;
  std::optional<std::span<const std::byte>> binary;  // the BIN chunk, if there is one
  bool is_glb = false;
  std::span<const std::byte> bytes;  // the whole file, without bytes behind a GLB's end
};

// The result refers to the bytes. A file is a GLB if it begins with the magic "glTF" or if
// must_be_glb is set. Throws SceneError (without a file name) for anything that the GLB chapter of
// glTF 2.0 forbids.
GltfContainer open_gltf_container(std::span<const std::byte> file, bool must_be_glb);

}  // namespace amalgam::scene
