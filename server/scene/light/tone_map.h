// The invertible tone curve from scene-linear radiance to display-linear values, and the sRGB
// encoding.
//
// TM(L) = e L / (1 + e L) per channel, e the exposure; the same e for I_m and I_r (numerics A4).
#pragma once

#include <glm/vec3.hpp>

#include "common/image.h"

namespace amalgam::scene {

// x / (1 + x), written so that infinity gives 1 and small x keep their digits (numerics B17).
float compress(float x);

// Its inverse d / (1 - d). d is clamped to [0, linear(254.5 / 255)], where the inverse is still
// finite.
float expand(float d);

glm::vec3 tone_map(const glm::vec3& scene_linear, float exposure);
glm::vec3 inverse_tone_map(const glm::vec3& display_linear, float exposure);

// IEC 61966-2-1. Bytes survive decode and encode exactly.
float srgb_decode(std::uint8_t byte);
float srgb_decode(float encoded);                // [0, 1] to display-linear
std::uint8_t srgb_encode(float display_linear);  // clamps to [0, 1], NaN to 0; rounds to nearest
glm::vec3 srgb_decode(const common::Rgb8& pixel);
common::Rgb8 srgb_encode(const glm::vec3& display_linear);

}  // namespace amalgam::scene
