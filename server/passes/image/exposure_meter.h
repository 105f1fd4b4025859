// Automatic exposure by grey card: the real surfaces are the card, the camera image is the meter.
//
// Let L_c = TM^-1 of the camera's color at exposure 1, and I_r the modelled radiance of the real
// surface seen there. With the exposure e that makes e I_r = L_c, virtual objects look as bright as
// real ones, if the model has the real surfaces' brightness. e is the median of L_c / I_r over the
// pixels where the camera sees a modelled real surface. Things that are not modelled (objects on
// the desk) are outliers; the median, unlike the usual log average (numerics B18), ignores them.
//
// A marker's paper, whose color is known, makes a better card: paper_meter.h.
#pragma once

#include <optional>

#include "common/camera_model.h"
#include "common/image.h"
#include "passes/image/meter_grid.h"
#include "scene/light/luminance.h"
#include "scene/light/tone_map.h"

namespace amalgam::passes {

// Outside these display-linear values the camera clips or is mostly noise.
float darkest_metered();
float brightest_metered();

using scene::luminance;

// Nothing if no entry has a usable pair (L_c, I_r). Pairs with black, saturated or non-finite
// members do not count. The result lies in [1e-6, 1e6].
std::optional<float> meter_exposure(const MeterGrid& grid, const common::CameraModel& ideal,
                                    const common::CameraModel& camera,
                                    const common::ImageRgb8& image,
                                    scene::ToneCurve curve = scene::ToneCurve::Reinhard);

}  // namespace amalgam::passes
