// Our materials in POV-Ray's words.
#pragma once

#include <string>

#include "scene/material.h"

namespace amalgam::bench {

// texture { ... } and, for glass, interior { ... }: what stands at the end of an object.
std::string pov_material(const scene::Material& material);

}  // namespace amalgam::bench
