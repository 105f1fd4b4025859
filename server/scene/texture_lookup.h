// Bilinear texture look-up on the CPU, agreeing with the rasteriser's sampler.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "scene/scene.h"

namespace amalgam::scene {

// Linear RGB and alpha at uv; (0, 0) is the top left corner of the image, texel centres at (i +
// 0.5) / size. Texels are decoded from sRGB before they are mixed.
glm::vec4 sample_color_texture(const Texture& texture, const glm::vec2& uv);

}  // namespace amalgam::scene
