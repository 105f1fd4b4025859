// Makes a mesh fit for rasteriser and ray tracer: drops triangles without area and recomputes bad
// normals (numerics B21). Counts both.
#pragma once

#include <cstddef>
#include <string>

#include "scene/scene.h"

namespace amalgam::scene {

struct MeshRepairs {
  std::size_t repeated_indices = 0;  // triangles dropped: two corners are the same vertex
  std::size_t zero_area = 0;         // triangles dropped: practically no area
  std::size_t bad_normals = 0;       // normals replaced: not finite or of length 0
  std::size_t scaled_normals = 0;    // normals brought to length 1
  bool computed_normals = false;     // there were none

  bool any() const;
  std::string describe() const;  // "dropped 2 triangles without area, ..."
};

// Indices must be in range and positions finite. Missing normals are computed flat, which gives
// each triangle its own three vertices. A bad normal becomes the area-weighted mean of its
// triangles' normals.
MeshRepairs repair_mesh(Mesh& mesh);

}  // namespace amalgam::scene
