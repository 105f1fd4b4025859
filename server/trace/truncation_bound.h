// What cutting off a sample's rays may have changed.
//
// A branch that is cut off takes w E, the weight times the environment, where the endless ray would
// have brought w X with 0 <= X <= the radiance limit. The tone curve is monotone, so both ends of
// this range bound the sample in display-linear light (numerics B8).
//
// Not bounded: everything else that the renderer approximates. The lights that stand for an
// environment, Schlick's formula, shadow maps, samples, pixels that adaptive sampling would have
// chosen otherwise, and the JPEG.
#pragma once

#include <glm/vec3.hpp>

#include "scene/light/tone_map.h"
#include "trace/radiance_limit.h"
#include "trace/tile_paths.h"

namespace amalgam::trace {

// For each channel, an upper bound of the composite's error, display-linear. 1 if the sample has
// met nothing virtual: the cut-off rays might have, and then the whole camera color is replaced.
glm::vec3 truncation_bound(const SampleResult& sample, const Truncation& truncation,
                           const RadianceLimit& limit, const scene::ToneMap& tone_map);

}  // namespace amalgam::trace
