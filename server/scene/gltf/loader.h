// Reads a glTF 2.0 scene into plain data: checked, resolved, and repaired where that is safe.
#pragma once

#include <filesystem>
#include <optional>

#include "scene/scene.h"
#include "scene/scene_error.h"

namespace amalgam::scene {

struct LoadOptions {
  bool load_environment = true;
  // Replaces the scene's own. May lie anywhere, because the operator names it and not a file.
  std::optional<std::filesystem::path> environment{};
};

// Reads a .gltf or .glb file with its buffers and pictures, from data URIs or files in the scene's
// own folder. Reads the default scene or else the first; without any scene, all root nodes. Throws
// SceneError naming the file and the wrong element. Repairs and ignored elements are in
// Scene::notes.
Scene load_scene(const std::filesystem::path& path, const LoadOptions& options = {});

}  // namespace amalgam::scene
