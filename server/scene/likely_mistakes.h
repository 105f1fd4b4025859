// What is right glTF and makes a picture that its author hardly wants.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace amalgam::scene {

// One line each: no light at all; glass that does not refract although it is a body; markers that
// the dictionary does not have; a dictionary's or a marker's odd measure.
std::vector<std::string> likely_mistakes(const Scene& scene);

// Nodes whose closed mesh holds the point, given in a marker's frame. For a camera's place.
std::vector<std::string> nodes_around(const Scene& scene, int marker, const glm::dvec3& point);

}  // namespace amalgam::scene
