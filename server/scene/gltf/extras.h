// A scene's glTF "extras": which objects are real, which marker they stand on, the world marker and
// the environment (design, "Scenes").
#pragma once

#include <optional>
#include <string>
#include <vector>

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
  bool has_world_marker = false;
  std::optional<std::string> environment;  // file name relative to the scene's folder
};

// Read "extras": {"amalgam": {"role", "marker"}} and Blender's bare "is_shadow_catcher" (true:
// real), which an explicit role overrides. Other extras are ignored. Throw SceneError with the path
// for a wrong or unknown member of "amalgam".
NodeExtras read_node_extras(const JsonCursor& node);
SceneExtras read_scene_extras(const JsonCursor& scene);

// Extras that look like ours and are not read, one line each: flat ("amalgam_role", "role") or
// wrongly spelt ("Amalgam"). Or one line if nothing in the file has extras of ours at all.
std::vector<std::string> doubtful_extras(const JsonCursor& root);

}  // namespace amalgam::scene
