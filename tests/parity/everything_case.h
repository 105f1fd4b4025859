// A made-up scene of what the scenes that come with Amalgam do not have: thin and nested and real
// glass, masked textures, a mirrored instance, a low-dynamic-range environment, lamps, emission.
#pragma once

#include "parity/parity_case.h"

namespace amalgam::parity {

// 160 x 120, no distortion, one sample a pixel, Schlick: for tests to change.
ParityCase make_everything_case();

}  // namespace amalgam::parity
