// Validates a glTF document before any library reads it. All refusals happen here and name the path
// of the wrong element. tinygltf 2.7.0 follows unchecked indices and sizes, and recurses as deep as
// the file nests.
//
// The rules are those of the glTF 2.0 specification ("must"). Refused is what makes the picture
// wrong or memory unsafe; every other breach is noted. The table of both stands in
// tests/unit/scene/gltf_slips_test.cpp and gltf_check_test.cpp.
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
