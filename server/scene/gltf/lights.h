// Reads and checks KHR_lights_punctual.
#pragma once

#include <vector>

#include "scene/gltf/check/json_value.h"
#include "scene/scene.h"

namespace amalgam::scene {

// The light definitions of a document, without place or node name. Throws SceneError.
std::vector<PunctualLight> read_lights(const JsonCursor& root);

// The light that a node carries, if any: an index into read_lights(). Throws SceneError.
std::optional<std::size_t> node_light(const JsonCursor& node, std::size_t light_count);

}  // namespace amalgam::scene
