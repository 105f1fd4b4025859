// The container of a glTF file: plain JSON (.gltf), or JSON and one binary buffer in chunks (.glb).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace amalgam::scene {

struct GltfContainer {
  std::string_view json;
  std::optional<std::span<const std::byte>> binary;  // the BIN chunk, if there is one
};

// The result refers to the bytes. A file is a GLB if it begins with the magic "glTF" or if
// must_be_glb is set. Notes what the GLB chapter of glTF 2.0 forbids and what loses nothing: chunks
// that are not padded, a length that is not the file's, bytes behind the last chunk. Throws
// SceneError (without a file name) for anything else.
GltfContainer open_gltf_container(std::span<const std::byte> file, bool must_be_glb,
                                  std::vector<std::string>& notes);

}  // namespace amalgam::scene
