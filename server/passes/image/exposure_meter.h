// Automatic exposure: the real surfaces are the grey card, the camera image is the light meter.
//
// Let L_c = TM^-1 of the camera's color at exposure 1, and I_r the modelled radiance of the real
// surface seen there. With the exposure e that makes e I_r = L_c, virtual objects look as bright as
// real ones. e is the median of L_c / I_r over the pixels where the camera sees a modelled real
// surface. Things that are not modelled (markers, objects on the desk) are outliers; the median,
// unlike the usual log average (numerics B18), ignores them.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "common/camera_model.h"
#include "common/image.h"

namespace amalgam::passes {

// A coarse grid over the ideal camera's *samples*: entry (x, y) is sample (x step + step / 2, y
// step + step / 2), clamped to the image. rgb: I_r, scene-linear; alpha 1 where the sample sees a
// real diffuse surface, otherwise 0.
struct MeterGrid {
  common::ImageRgba32f real;
  int step = 1;
  int samples_per_side = 1;
};

// Distance between grid entries, in samples, for about 5,000 entries at most.
int meter_step(glm::ivec2 sample_size);

// Nothing if no entry has a usable pair (L_c, I_r); the exposure then stays as it was, 1 at first.
// Pairs with black, saturated or non-finite members do not count. The result lies in [1e-6, 1e6].
std::optional<float> meter_exposure(const MeterGrid& grid, const common::CameraModel& ideal,
                                    const common::CameraModel& camera,
                                    const common::ImageRgb8& image);

}  // namespace amalgam::passes
