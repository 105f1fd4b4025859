// Spheres of equal triangles, from 20 to any number, with smooth normals: the coarser, the further
// the normals lean from the triangles.
#pragma once

#include "scene/scene.h"

namespace amalgam::test_support {

// Radius 1, about the origin; 20 * 4^subdivisions triangles.
scene::Mesh make_icosphere(int subdivisions);

}  // namespace amalgam::test_support
