// Reads and checks KHR_lights_punctual.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/check/json_value.h"
#include "scene/scene.h"

namespace amalgam::scene {

// The light definitions of a document, without place or node name. Adds to notes, if there is a
// list. Throws SceneError.
std::vector<PunctualLight> read_lights(const JsonCursor& root,
                                       std::vector<std::string>* notes = nullptr);

// The light that a node carries, if any: an index into read_lights(). Throws SceneError.
std::optional<std::size_t> node_light(const JsonCursor& node, std::size_t light_count);

}  // namespace amalgam::scene
