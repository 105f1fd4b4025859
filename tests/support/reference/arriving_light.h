// What arrives at a point from a light if nothing is in between.
#pragma once

#include "scene/light/light.h"
#include "support/reference/vectors.h"

namespace amalgam::reference {

struct ArrivingLight {
  Vec3 to_light{0.0};           // unit
  double distance = kInfinity;  // metres
  Color irradiance{0.0};        // on a surface facing the light
};

ArrivingLight arriving_light(const scene::Light& light, const Vec3& point);

}  // namespace amalgam::reference
