// numerics B9: in a furnace of radiance 1 what neither absorbs nor glows looks like the furnace.
#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace amalgam::trace {

// A branch that is cut takes the environment, so truncation takes nothing in a furnace. What stays
// is rounding: each of at most 2^10 branches of a sample rounds 20 times on its way and once when
// it is summed up, 2^-24 each, to either side: 1e-4 if all erred alike. Observed: below 1e-6.
inline constexpr float kFurnaceBound = 5e-6f;

// Every pixel that shows one of the scene's objects (virtual ones, about the origin, some 2 m
// across) shows 1, and n^2 from within a medium: from three sides and from within, for several
// depths and cut-offs.
void expect_furnace(const scene::Scene& scene);

}  // namespace amalgam::trace
