// What a surface is made of at one point: the material's factors times what its textures and the
// vertices' colors say there (glTF 2.0, 3.9; scene/material.h for the slots).
#pragma once

#include <array>
#include <span>

#include "scene/scene.h"
#include "support/reference/ray.h"

namespace amalgam::reference {

// What a mesh says of a vertex besides its place and normal. World frame.
struct VertexAttributes {
  std::array<Vec2, 2> uvs{};          // both sets of texture coordinates
  Vec4 color{1.0};                    // linear
  Vec3 tangent{0.0}, bitangent{0.0};  // a normal texture's +x and +y, not unit; zero: not known
};

struct TriangleAttributes {
  std::array<VertexAttributes, 3> corners{};
  std::array<double, 2> uv_per_area{};  // area in uv over area in m^2, of both sets
};

struct SurfacePlace {
  const scene::Material& material;
  const TriangleAttributes& triangle;
  const Hit& hit;
  std::span<const scene::Texture> textures;
};

struct SurfaceMaterial {
  Vec4 base_color{1.0};  // linear; alpha
  Color emission{0.0};   // scene-linear
  double metallic = 0.0, roughness = 1.0;
  double transmission = 1.0;  // of glass: share of what is not reflected
  Vec3 normal{0.0};           // unit, outside; the interpolated one, bent by a normal texture
};

Vec4 base_color(const SurfacePlace& place);
SurfaceMaterial surface_material(const SurfacePlace& place);

}  // namespace amalgam::reference
