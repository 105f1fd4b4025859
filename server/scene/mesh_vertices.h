// Duplicates a vertex with all its attributes.
#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace amalgam::scene {

// Attributes that `from` lacks are not added. to and from may be the same mesh.
inline void append_vertex(Mesh& to, const Mesh& from, std::size_t vertex) {
  const auto copy = [vertex](auto& out, const auto& in) {
    if (in.empty()) return;
    const auto value = in[vertex];  // `in` may be `out`, which may grow
    out.push_back(value);
  };
  copy(to.positions, from.positions);
  copy(to.normals, from.normals);
  copy(to.uvs, from.uvs);
  copy(to.second_uvs, from.second_uvs);
  copy(to.colors, from.colors);
  copy(to.tangents, from.tangents);
}

}  // namespace amalgam::scene
