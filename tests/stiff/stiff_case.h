// A stiff scene as the two renderers are given it.
#pragma once

#include "parity/parity_case.h"
#include "support/stiff_scenes.h"

namespace amalgam::stiff {

// Seen from its pose, behind a made-up camera image.
parity::ParityCase make_case(const test_support::StiffScene& scene, int width, int height);

}  // namespace amalgam::stiff
