// Trilinear texture look-up on the CPU, equal to shaders/texture_lookup.glsl.
//
// The level of detail comes from ray cones in both renderers (Akenine-Moller et al., "Texture Level
// of Detail Strategies for Real-Time Ray Tracing", Ray Tracing Gems, 2019, ch. 20, eq. 2 to 6;
// curvature ignored). A driver's derivatives would give traced and rasterised surfaces different
// texels. A cone of width d that meets a triangle at cosine c has a footprint of side d / |c| on
// it, and
//   footprint = uv area / world area (d / |c|)^2,    lod = log2(footprint width height) / 2
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "scene/scene.h"

namespace amalgam::scene {

// Also in shaders (gl/shader_constants.h): the least |cosine| of a footprint, and the distance from
// the texture's corner, in texels, beyond which look-ups return black.
constexpr float kMinFootprintCosine = 1e-4f;
constexpr float kMaxTexelPlace = 1e9f;
// A normal texture ignores a tangent of which less than this share of its length lies in the
// surface.
constexpr double kMinTangentShare = 1e-6;

// RGBA in [0,1] at uv; (0, 0) is the top left corner of the image, texel centres at (i + 0.5) /
// size. footprint: area in uv of one sample, >= 0; 0 reads the full size. Colors are decoded from
// sRGB before they are interpolated (alpha is linear); data is linear.
glm::vec4 sample_color_texture(const Texture& texture, const glm::vec2& uv, float footprint = 0.0f);
glm::vec4 sample_data_texture(const Texture& texture, const glm::vec2& uv, float footprint = 0.0f);

// See above. uv_area_per_area: of the triangle, uv area over world area. cosine: between the ray
// and the triangle's normal.
float uv_footprint(float uv_area_per_area, float cone_width, float cosine);

// Area in uv over area in mesh space of a triangle; 0 if the mesh has no such coordinates.
float uv_area_ratio(const Mesh& mesh, const std::vector<glm::vec2>& uvs, const glm::uvec3& corners);

}  // namespace amalgam::scene
