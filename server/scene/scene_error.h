// Thrown if a scene cannot be used.
#pragma once

#include <stdexcept>

namespace amalgam::scene {

// One line that names the file and the wrong element in it, for instance "desk.gltf:
// meshes[2].primitives[0].indices: there is no accessor 17 (the file has 4)".
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace amalgam::scene
