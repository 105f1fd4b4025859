// The transparent media that a point lies in: what rays from there start with.
#pragma once

#include "support/reference/media_stack.h"
#include "support/reference/world.h"

namespace amalgam::reference {

// By winding numbers: of each medium's surfaces around the point. Open surfaces hold nothing.
MediaStack media_around(const World& world, const Vec3& point);

}  // namespace amalgam::reference
