// The mip levels of a texture, made once and on the CPU, so that both renderers read the same
// texels.
#pragma once

#include <cstdint>
#include <vector>

#include "common/image.h"

namespace amalgam::scene {

enum class TexelEncoding : std::uint8_t { Srgb, Linear };

// Levels of half the size each (rounded down, at least 1), down to 1x1. Every texel is the exact
// mean, in linear light, of the area that it covers, also for odd sizes. Encoded like the input;
// alpha is always linear.
std::vector<common::ImageRgba8> make_mips(const common::ImageRgba8& texels, TexelEncoding encoding);

}  // namespace amalgam::scene
