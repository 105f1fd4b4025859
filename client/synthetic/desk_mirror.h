// The real mirror of deploy/scenes/complex.gltf on the synthetic desk, so that what the renderer
// draws into it does not hang in the air. A test compares it with the scene's node.
//
// Points and directions are in OpenCV's marker frame, metres.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "client/synthetic/packed_color.h"

namespace amalgam::client {

class DeskMirror {
 public:
  DeskMirror();

  struct Meeting {
    double t = 0.0;          // in lengths of the direction
    glm::dvec3 normal{0.0};  // unit, towards the ray's origin
  };
  // Where a ray from outside first meets it. It is a box, and a mirror on all sides.
  std::optional<Meeting> meet(const glm::dvec3& origin, const glm::dvec3& direction) const;

  // What a color looks like in it, by Schlick's formula for conductors. cosine: between the ray and
  // the normal, 0 to 1.
  static PackedColor dim(PackedColor color, double cosine);

 private:
  glm::dmat3 box_from_marker_;  // the box is [-1/2, 1/2] x [0, 1] x [-1/2, 1/2]
  glm::dvec3 place_;            // the middle of its lower face
};

}  // namespace amalgam::client
