// The material at a hit: its factors times its textures and vertex colors.
//
// shaders/surface_material.glsl is the rasteriser's counterpart.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "trace/embree_scene.h"

namespace amalgam::trace {

// The ray's footprint on the triangle, for the level of detail.
struct TexelFootprint {
  float cosine = 1.0f;      // of the ray and the triangle's plane normal; any sign
  float cone_width = 0.0f;  // metres
  float world_area_per_mesh_area = 1.0f;
};

class Texels {
 public:
  Texels(const scene::Scene& scene, const Hit& hit, const TexelFootprint& footprint);

  glm::vec4 base_color() const;
  glm::vec3 emission() const;
  glm::vec2 metallic_roughness() const;
  float transmission() const;

  // normal: interpolated, unit, world frame, outward. Returns it bent by the normal texture, unit;
  // unchanged without a normal texture or without a tangent there.
  glm::dvec3 bent_normal(const glm::dvec3& normal, const PlacedInstance& placed) const;

 private:
  bool has(scene::TextureSlot slot) const { return scene::has_texture(material_, mesh_, slot); }
  glm::vec4 sample(scene::TextureSlot slot) const;

  const scene::Scene& scene_;
  const scene::Mesh& mesh_;
  const scene::Material& material_;
  glm::uvec3 corners_;
  glm::vec2 barycentric_;
  TexelFootprint footprint_;
};

}  // namespace amalgam::trace
