#include "common/pose.h"

#include <cmath>

namespace amalgam::common {

// Comparisons are written so that a NaN anywhere makes them false.

bool is_unit(const glm::dquat& q) {
  const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  constexpr double kMaxLengthError = 1e-3;
  return std::abs(length - 1.0) <= kMaxLengthError;
}

bool is_usable(const MarkerPose& pose) {
  constexpr double kMaxDistance = 1e7;
  return is_unit(pose.rotation) && std::abs(pose.translation.x) <= kMaxDistance &&
         std::abs(pose.translation.y) <= kMaxDistance &&
         std::abs(pose.translation.z) <= kMaxDistance;
}

glm::dmat4 to_matrix(const MarkerPose& pose) {
  glm::dmat4 matrix = glm::mat4_cast(glm::normalize(pose.rotation));
  matrix[3] = glm::dvec4(pose.translation, 1.0);
  return matrix;
}

glm::dmat4 rigid_inverse(const glm::dmat4& rigid) {
  const glm::dmat3 rotation = glm::transpose(glm::dmat3(rigid));
  glm::dmat4 inverse(rotation);
  inverse[3] = glm::dvec4(-(rotation * glm::dvec3(rigid[3])), 1.0);
  return inverse;
}

glm::dmat4 opencv_marker_from_gltf() {
  return glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(0, -1, 0, 0),
                    glm::dvec4(0, 0, 0, 1));
}

}  // namespace amalgam::common
