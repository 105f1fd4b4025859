// Finds the pixel at which the camera sees a real surface that a ray met (section 4.4, eq. 4.10).
//
// The thesis projects the point and checks the image's border only. Here the point must also lie in
// front of the camera (numerics A1, B15), on the side of the surface that faces it, and not be
// occluded by other real geometry.
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

// The camera and the real depth seen by it. Without depth, a visibility ray decides every point.
struct CameraView {
  common::CameraModel camera;  // with distortion
  glm::dmat4 camera_from_world{1.0};
  common::CameraModel ideal;  // the camera of real_depth
  // Camera-frame z of the nearest real surface, metres.
  const common::Image32f* real_depth = nullptr;
};

struct CameraPlace {
  glm::vec2 pixel{0.0f};  // pixel centres are integers
  // (0, 1]: the camera's share of the color. Falls to 0 over a band along the image's border.
  float trust = 0.0f;
};

class CameraLookup {
 public:
  explicit CameraLookup(const CameraView& view);

  // Nothing if the camera does not see the point. Adds the visibility rays that it casts to
  // lookup_rays.
  std::optional<CameraPlace> find(const EmbreeScene& scene, const SurfacePoint& point,
                                  std::uint64_t& lookup_rays) const;

 private:
  enum class DepthVerdict { Visible, Hidden, Unsure };
  DepthVerdict judge_by_depth(const glm::dvec3& point_in_camera) const;

  CameraView view_;
  glm::dvec3 camera_in_world_;
};

}  // namespace amalgam::trace
