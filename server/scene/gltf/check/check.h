// Judges a glTF document before any library reads it: everything that is refused is refused here,
// with the path of the element that is wrong. tinygltf 2.7.0 follows indices and sizes it has not
// checked, and recurses as deep as a file says.
//
// The rules are those of the glTF 2.0 specification ("must"). Breaches that cannot change the
// picture are noted instead: undeclared extensions, missing or rounded accessor bounds, shared
// strides.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/check/json_value.h"

namespace amalgam::scene {

// Throws SceneError without a file name. binary_bytes: the size of a GLB's BIN chunk. Adds to
// notes.
void check_gltf(const JsonCursor& root, std::optional<std::size_t> binary_bytes,
                std::vector<std::string>& notes);

}  // namespace amalgam::scene
