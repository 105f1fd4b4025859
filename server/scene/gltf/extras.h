// What a scene says in glTF "extras": which objects are real, which marker they stand on, and what
// the world marker and environment are (design, "Scenes").
#pragma once

#include <optional>
#include <string>

#include "scene/gltf/check/json_value.h"
#include "scene/scene.h"

namespace amalgam::scene {

// What one node says itself; children inherit what they do not say.
struct NodeExtras {
  std::optional<Role> role;
  std::optional<int> marker;  // 0 .. 1e6
};

struct SceneExtras {
  World world;
  bool has_world_marker = false;
  std::optional<std::string> environment;  // file name relative to the scene's folder
};

// Read "extras": {"amalgam": {"role", "marker"}} and Blender's bare "is_shadow_catcher" (true:
// real), which an explicit role overrides. Extras that are not objects, or not ours, are nobody's
// business here. Throw SceneError with the path for a member of ours that is wrong or unknown.
NodeExtras read_node_extras(const JsonCursor& node);
SceneExtras read_scene_extras(const JsonCursor& scene);

}  // namespace amalgam::scene
