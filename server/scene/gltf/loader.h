// Reads a glTF 2.0 scene into plain data, checked, repaired where that is safe, and resolved.
#pragma once

#include <filesystem>
#include <optional>

#include "scene/scene.h"
#include "scene/scene_error.h"

namespace amalgam::scene {

struct LoadOptions {
  bool load_environment = true;
  // Replaces the scene's own; may lie anywhere, since the operator says it and not a file.
  std::optional<std::filesystem::path> environment{};
};

// A .gltf or .glb file, its buffers and pictures in data URIs or files in the scene's own folder.
// The default scene (or the first) is read; without any scene all root nodes are. Throws SceneError
// whose text names the file and the element that is wrong; what was repaired or ignored is in
// Scene::notes.
Scene load_scene(const std::filesystem::path& path, const LoadOptions& options = {});

}  // namespace amalgam::scene
