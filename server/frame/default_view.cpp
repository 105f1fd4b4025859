#include "frame/default_view.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace amalgam::frame {

common::MarkerPose default_pose(int world_marker) {
  const glm::dvec3 eye(0.0, 0.33, 0.42), target(-0.02, 0.03, -0.06);  // glTF axes on the marker
  const glm::dvec3 forward = glm::normalize(target - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
  const glm::dvec3 down = glm::cross(forward, right);
  const glm::dmat3 camera_from_gltf = glm::transpose(glm::dmat3(right, down, forward));
  const glm::dmat3 gltf_from_marker(common::rigid_inverse(common::opencv_marker_from_gltf()));
  return {world_marker, glm::quat_cast(camera_from_gltf * gltf_from_marker),
          -(camera_from_gltf * eye)};
}

}  // namespace amalgam::frame
