// The smaller sizes of a texture, made once and on the CPU, so that both renderers read the same
// texels.
#pragma once

#include <cstdint>
#include <vector>

#include "common/image.h"

namespace amalgam::scene {

enum class TexelEncoding : std::uint8_t { Srgb, Linear };

// Half the size each (rounded down, at least 1), down to 1x1. Every texel is the mean of the area
// that it covers, in linear light, whatever the size is divisible by; encoded again as the texels
// are. Alpha is linear always.
std::vector<common::ImageRgba8> make_mips(const common::ImageRgba8& texels, TexelEncoding encoding);

}  // namespace amalgam::scene
