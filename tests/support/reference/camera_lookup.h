// The camera's own color of a real surface that a secondary ray met (eq. 4.10, 4.11), if the
// camera sees that point.
#pragma once

#include "common/camera_model.h"
#include "common/image.h"
#include "support/reference/color_curves.h"
#include "support/reference/world.h"

namespace amalgam::reference {

struct CameraView {
  const common::ImageRgb8* image = nullptr;  // size of the camera
  common::CameraModel camera;                // with distortion
  glm::dmat4 camera_from_world{1.0};
  Response response;
};

struct LookUp {
  double trust = 0.0;  // [0, 1]: 0 if the camera does not see the point, rising from the border
  Color radiance{0.0};
};

// facing_normal: the geometric one on the side from which the point was met.
LookUp look_up(const World& world, const CameraView& view, const Vec3& point,
               const Vec3& facing_normal);

// How much a look-up counts: smoothstep over the outermost 4 % of the image's shorter side.
double border_trust(const common::CameraModel& camera, const Vec2& pixel);

}  // namespace amalgam::reference
