// A scene's glTF "extras": which objects are real, which marker they stand on, the world marker and
// the environment (design, "Scenes").
#pragma once

#include <optional>
#include <string>

#include "scene/gltf/check/json_value.h"
#include "scene/scene.h"

namespace amalgam::scene {

// One node's own extras. Children inherit what they leave unset.
struct NodeExtras {
  std::optional<Role> role;
  std::optional<int> marker;  // 0 .. 1e6
};

struct SceneExtras {
  World world;
  std::optional<std::string> environment;  // file name relative to the scene's folder
};

// Read "extras": {"amalgam": {"role", "marker"}} and Blender's bare "is_shadow_catcher" (true:
// real), which an explicit role overrides. "amalgam" may also be a string that holds the object as
// JSON: what Blender exports for a custom property of type String. Other extras are ignored. Throw
// SceneError with the path for a wrong or unknown member of "amalgam".
NodeExtras read_node_extras(const JsonCursor& node);
SceneExtras read_scene_extras(const JsonCursor& scene);

}  // namespace amalgam::scene
