// A glTF file that has passed our checks, as tinygltf gives it. Only the gltf_* files of this
// folder include this, and tinygltf's header is included nowhere else.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <string>
#include <vector>

#include "scene/gltf/check/json_value.h"

namespace amalgam::scene {

struct GltfModel {
  tinygltf::Model model;  // images hold the encoded bytes of their files (as_is), in Image::image
  JsonValue document;     // the same file's JSON, for extras and extensions
};

// Reads a .gltf or .glb file with all that it refers to. Throws SceneError without the file's name.
GltfModel load_gltf_model(const std::filesystem::path& path, std::vector<std::string>& notes);

}  // namespace amalgam::scene
