// What the exposure meter knows of the real surfaces in view.
#pragma once

#include <glm/vec2.hpp>

#include "common/camera_model.h"
#include "common/image.h"

namespace amalgam::passes {

// A coarse grid over the ideal camera's *samples*: entry (x, y) is sample (x step + step / 2, y
// step + step / 2), clamped to the image. Scene-linear; alpha 1 where the sample sees a real
// diffuse surface, otherwise all is 0.
struct MeterGrid {
  common::ImageRgba32f real;   // I_r
  common::ImageRgba32f white;  // I_r of a white Lambertian surface there: irradiance / pi
  int step = 1;
  int samples_per_side = 1;

  // Where an entry lies in the ideal image; pixel centres are integers.
  glm::dvec2 ideal_pixel(int x, int y, const common::CameraModel& ideal) const;
};

// Distance between grid entries, in samples, for about 5,000 entries at most.
int meter_step(glm::ivec2 sample_size);

}  // namespace amalgam::passes
