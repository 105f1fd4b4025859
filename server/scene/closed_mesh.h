// Whether a mesh bounds a solid, and which way it faces.
#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace amalgam::scene {

// Every edge, of corners at equal positions, is run through as often in one direction as in the
// other.
bool is_closed(const Mesh& mesh);

// Cubic units of the mesh; positive if a closed mesh's triangles are counter-clockwise from
// outside.
double signed_volume(const Mesh& mesh);

// Sum over triangles of area times the cosine between vertex normals and the triangle's own.
double normals_along_winding(const Mesh& mesh);

// 0 outside a closed mesh, +-1 inside (Van Oosterom and Strackee's solid angles over 4 pi).
double winding_number(const Mesh& mesh, const glm::dvec3& point);

// Turns triangles round, or normals; tangents keep the bitangent.
void flip_winding(Mesh& mesh);
void flip_normals(Mesh& mesh);

}  // namespace amalgam::scene
