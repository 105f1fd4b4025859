// A made-up scene of everything that textures and vertices can say of a material: all kinds of
// textures with their smaller sizes, both sets of coordinates, tangents on stretched and mirrored
// instances, vertex colors, glass that lets a part through.
#pragma once

#include "parity/parity_case.h"

namespace amalgam::parity {

// 160 x 120, no distortion, one sample a pixel, Schlick: for tests to change.
ParityCase make_materials_case();

}  // namespace amalgam::parity
