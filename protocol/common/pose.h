// Rigid poses of markers, from a tracker and over the wire.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace amalgam::common {

// camera_from_marker as OpenCV gives it. Camera frame: x right, y down, z forward. Marker frame:
// origin at its centre, x along its right, y along its top, z out of the paper. Translation in
// metres.
struct MarkerPose {
  int marker = 0;
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  // unit; glm's constructor order is w, x, y, z
  glm::dvec3 translation{0.0};
};

// A unit quaternion to within a length of 1e-3 (numerics B22).
bool is_unit(const glm::dquat& rotation);

// A pose is usable if it is finite, its quaternion is a unit one and
// no coordinate of its translation exceeds 1e7 m.
bool is_usable(const MarkerPose& pose);

// The rigid transform camera_from_marker of a usable pose (quaternion normalised here).
glm::dmat4 to_matrix(const MarkerPose& pose);

// The inverse of a rotation and translation, by transposing (numerics B23). Not for scaled
// matrices.
glm::dmat4 rigid_inverse(const glm::dmat4& rigid);

// From glTF's frame on a marker (origin at its centre, +Y out of the paper, +X along its right) to
// OpenCV's marker frame: maps (x, y, z) to (x, -z, y).
glm::dmat4 opencv_marker_from_gltf();

}  // namespace amalgam::common
