// Turns solid glass outward whose triangles or normals point inward: rays would enter where they
// leave, and nearly all of them end at the depth limit.
#pragma once

#include "scene/scene.h"

namespace amalgam::scene {

// Closed meshes that only solid glass wears, with a warning for each. One inside another glass
// object may be its hollow, which faces inward rightly: it stays. Notes that a scene has too many
// bodies of glass to compare them all.
void turn_glass_outward(Scene& scene);

}  // namespace amalgam::scene
