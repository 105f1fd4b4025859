// How much of a light reaches a point, by the rays that go on through glass (section 4.3).
#pragma once

#include "support/reference/arriving_light.h"
#include "support/reference/decisions.h"
#include "support/reference/world.h"

namespace amalgam::reference {

// Attenuations in [0, 1]: with everything, and with real objects only.
struct Shadow {
  Color mixed{1.0};
  Color real{1.0};
};

Shadow cast_shadow_ray(const World& world, const Vec3& point, const ArrivingLight& light,
                       Decisions& decisions);

}  // namespace amalgam::reference
