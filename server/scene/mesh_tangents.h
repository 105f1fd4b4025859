// Tangents for normal textures, where the file gives none.
#pragma once

#include "scene/scene.h"

namespace amalgam::scene {

// Makes Mesh::tangents usable: those given are cleaned (not finite: zero; w becomes +-1), missing
// ones computed from the texture coordinates after Lengyel (Foundations of Game Engine Development
// 2, 7.5): at each vertex the sum of its triangles' tangents, made perpendicular to the normal.
// Vertices that mirrored and plain triangles share are split. Without coordinates there are none.
void complete_tangents(Mesh& mesh, bool from_second_uvs);

}  // namespace amalgam::scene
