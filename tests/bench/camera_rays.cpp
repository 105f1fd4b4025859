#include "bench/camera_rays.h"

#include <glm/geometric.hpp>
#include <limits>

#include "common/pose.h"

namespace amalgam::bench {

std::vector<trace::Ray> camera_rays(const common::CameraModel& camera,
                                    const glm::dmat4& camera_from_world) {
  const glm::dmat4 world_from_camera = common::rigid_inverse(camera_from_world);
  const glm::vec3 eye(world_from_camera[3]);
  std::vector<trace::Ray> rays;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const glm::dvec3 seen = *common::pixel_direction(camera, glm::dvec2(x, y));
      const glm::vec3 direction(glm::normalize(glm::dmat3(world_from_camera) * seen));
      rays.push_back({eye, direction, std::numeric_limits<float>::infinity()});
    }
  }
  return rays;
}

}  // namespace amalgam::bench
