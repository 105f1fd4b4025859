// Where the camera sees a real surface that a ray met (section 4.4, eq. 4.10).
//
// The thesis projects and checks the image's border only. Here a point also has to be in front of
// the camera (numerics A1, B15) and be what the camera sees there: on the side of the surface that
// faces it and not hidden by other real geometry.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "common/camera_model.h"
#include "common/image.h"
#include "trace/embree_scene.h"
#include "trace/surface_point.h"

namespace amalgam::trace {

// The camera, and what it is known to see. The depth may be missing: then every point is decided by
// a ray.
struct CameraView {
  common::CameraModel camera;  // with distortion
  glm::dmat4 camera_from_world{1.0};
  common::CameraModel ideal;  // the camera of real_depth
  const common::Image32f* real_depth =
      nullptr;  // camera-frame z of the nearest real surface, metres
};

struct CameraPlace {
  glm::vec2 pixel{0.0f};  // pixel centres are integers
  // (0, 1]: the camera's share of the color; falls to 0 over the last few pixels before the
  // image's border.
  float trust = 0.0f;
};

class CameraLookup {
 public:
  explicit CameraLookup(const CameraView& view);

  // Nothing if the camera does not see the point. lookup_rays counts the rays that were needed to
  // decide.
  std::optional<CameraPlace> find(const EmbreeScene& scene, const SurfacePoint& point,
                                  std::uint64_t& lookup_rays) const;

 private:
  enum class DepthVerdict { Visible, Hidden, Unsure };
  DepthVerdict judge_by_depth(const glm::dvec3& point_in_camera) const;

  CameraView view_;
  glm::dvec3 camera_in_world_;
};

}  // namespace amalgam::trace
