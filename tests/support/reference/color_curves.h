// The two curves between light and bytes: tone mapping (scene-linear to display-linear) and sRGB
// (display-linear to 8 bit), in double.
#pragma once

#include <cstdint>

#include "support/reference/vectors.h"

namespace amalgam::reference {

// IEC 61966-2-1, both directions; arguments in [0, 1].
double srgb_decode(double encoded);
double srgb_encode(double display_linear);

// The decoded value of a byte, from a table.
double srgb_decode_byte(std::uint8_t byte);
// Clamps to [0, 1] and rounds to nearest.
std::uint8_t srgb_encode_byte(double display_linear);

// How a camera answers to light, per channel (eq. 4.3, 4.4 with one exposure e for both images).
struct Response {
  double exposure = 1.0;
  bool linear = false;
};

// TM(L) = e L / (1 + e L), or the lesser of e L and 1.
Color tone_map(const Color& scene_linear, const Response& response);

// TM^-1(d) = d / (1 - d) / e, with d clamped to [0, decoded 254.5/255] where it is still finite; or
// d / e.
Color inverse_tone_map(const Color& display_linear, const Response& response);

}  // namespace amalgam::reference
