// Tangents for normal textures.
#pragma once

#include "scene/scene.h"

namespace amalgam::scene {

// Cleans given tangents: not finite ones become zero, w becomes +-1. Computes missing ones from the
// texture coordinates after Lengyel (Foundations of Game Engine Development 2, 7.5): at each vertex
// the sum of its triangles' tangents, made perpendicular to the normal. Vertices shared by mirrored
// and unmirrored triangles are split. Without coordinates there are no tangents.
void complete_tangents(Mesh& mesh, bool from_second_uvs);

}  // namespace amalgam::scene
