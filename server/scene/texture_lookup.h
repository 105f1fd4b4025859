// Trilinear texture look-up on the CPU, agreeing with shaders/texture_lookup.glsl.
//
// The level of detail comes from ray cones in both renderers (Akenine-Moller et al., "Texture Level
// of Detail Strategies for Real-Time Ray Tracing", Ray Tracing Gems, 2019, ch. 20, eq. 2 to 6;
// curvature ignored), not from a driver's derivatives, so that traced and rasterised surfaces show
// the same texels. A cone of width d that meets a triangle under the cosine c covers a square of
// side d / |c| on it, and
//   footprint = uv area / world area (d / |c|)^2,    lod = log2(footprint width height) / 2
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "scene/scene.h"

namespace amalgam::scene {

// In C++ and in shaders (gl/shader_constants.h): the cosine of a ray that grazes, at least; how
// many texels from the corner anything is shown. What lies further out is black.
constexpr float kMinFootprintCosine = 1e-4f;
constexpr float kMaxTexelPlace = 1e9f;
// A tangent is of no use to a normal texture if less of its length than this lies in the surface.
constexpr double kMinTangentShare = 1e-6;

// RGBA in [0,1] at uv; (0, 0) is the top left corner of the image, texel centres at (i + 0.5) /
// size. footprint: area in uv that one sample covers, >= 0; at 0 the full size is read.
// Colors are decoded from sRGB before they are mixed (alpha is linear), data is linear.
glm::vec4 sample_color_texture(const Texture& texture, const glm::vec2& uv, float footprint = 0.0f);
glm::vec4 sample_data_texture(const Texture& texture, const glm::vec2& uv, float footprint = 0.0f);

// See above. uv_area_per_area: of the triangle, uv per world. cosine: of the ray and the triangle.
float uv_footprint(float uv_area_per_area, float cone_width, float cosine);

// Area in uv over area in mesh space of a triangle; 0 if the mesh has no such coordinates.
float uv_area_ratio(const Mesh& mesh, const std::vector<glm::vec2>& uvs, const glm::uvec3& corners);

}  // namespace amalgam::scene
