// A glTF file that has passed our checks, as tinygltf's model. Only for this folder: no other code
// sees tinygltf.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <string>
#include <vector>

#include "scene/gltf/check/json_value.h"

namespace amalgam::scene {

struct GltfModel {
  // Its buffers are decompressed. Image::image holds a picture's encoded bytes.
  tinygltf::Model model;
  JsonValue document;  // the same file's JSON, for extras and extensions
};

// Reads a .gltf or .glb file and the files that it refers to. Throws SceneError without the file's
// name.
GltfModel load_gltf_model(const std::filesystem::path& path, std::vector<std::string>& notes);

}  // namespace amalgam::scene
