// A camera without hardware: renders the synthetic desk from exactly known poses.
//
// A frame depends on its pose alone and is the same on every machine. Lens distortion is that of
// common/camera_model.h.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "client/synthetic/synthetic_desk.h"
#include "common/camera_model.h"
#include "common/image.h"
#include "common/pose.h"

namespace amalgam::client {

struct SyntheticFrame {
  common::ImageRgb8 image;
  common::MarkerPose pose;  // true camera_from_marker
};

class SyntheticCamera {
 public:
  // The desk may be shared between cameras; making one takes some tenths of a second. Throws
  // std::runtime_error if the camera has a defect.
  SyntheticCamera(const common::CameraModel& camera, std::shared_ptr<const SyntheticDesk> desk);
  explicit SyntheticCamera(const common::CameraModel& camera);

  // Frame 0, 1, ... of the path in synthetic_path.h.
  SyntheticFrame render(std::uint64_t frame) const;

  // The desk as seen from any pose in front of it.
  common::ImageRgb8 render(const common::MarkerPose& pose) const;

  const common::CameraModel& camera() const { return camera_; }

 private:
  struct Sight {
    glm::dvec3 from{0.0};       // marker frame, metres
    glm::dvec3 direction{0.0};  // of length 1 along z of the camera
    double distance = 0.0;      // from the camera to `from`, in lengths of the direction
  };
  // sample_angle: the width of a sample, radians.
  PackedColor look(const Sight& sight, double sample_angle) const;
  PackedColor look_at_desk(const Sight& sight, double sample_angle) const;  // and not the mirror
  glm::dvec2 ray(int sample_x, int sample_y) const;

  common::CameraModel camera_;
  std::shared_ptr<const SyntheticDesk> desk_;
  // Directions (x, y with z = 1) of the samples: one for each, row by row; without distortion one
  // for each column and each row.
  std::vector<glm::dvec2> distorted_rays_;
  std::vector<double> column_x_, row_y_;
};

}  // namespace amalgam::client
