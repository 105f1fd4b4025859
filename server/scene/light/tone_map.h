// The camera's response: a tone curve from scene-linear radiance to display-linear values, and the
// sRGB encoding.
//
//   Reinhard   TM(L) = e L / (1 + e L)     invertible; the thesis's framework
//   Linear     TM(L) = min(e L, 1)         clips, as most cameras do
//
// per channel, e the exposure. The same e for I_m and I_r (numerics A4).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>

#include "common/image.h"

namespace amalgam::scene {

enum class ToneCurve : std::uint8_t { Reinhard, Linear };
inline constexpr ToneCurve kToneCurves[] = {ToneCurve::Reinhard, ToneCurve::Linear};

// Throws std::invalid_argument naming the choices.
ToneCurve parse_tone_curve(std::string_view text);
const char* tone_curve_name(ToneCurve curve);

struct ToneMap {
  glm::vec3 exposure{1.0f};  // of each channel: brightness and white balance
  ToneCurve curve = ToneCurve::Reinhard;
  bool operator==(const ToneMap&) const = default;
};

// Without white balance.
inline ToneMap tone_map_of(float exposure, ToneCurve curve = ToneCurve::Reinhard) {
  return {glm::vec3(exposure), curve};
}

// Reinhard's x / (1 + x), written so that infinity gives 1 and small x keep their digits (numerics
// B17).
float compress(float x);

// Its inverse d / (1 - d). d is clamped to [0, linear(254.5 / 255)], where the inverse is still
// finite.
float expand(float d);

glm::vec3 tone_map(const glm::vec3& scene_linear, const ToneMap& tone_map);
// Of clipped values, Linear gives the least radiance that clips.
glm::vec3 inverse_tone_map(const glm::vec3& display_linear, const ToneMap& tone_map);

// TM(b) - TM(a) for a <= b, without cancellation where they are near.
glm::vec3 tone_map_step(const glm::vec3& a, const glm::vec3& b, const ToneMap& tone_map);

// IEC 61966-2-1. Bytes survive decode and encode exactly.
float srgb_decode(std::uint8_t byte);
float srgb_decode(float encoded);                // [0, 1] to display-linear
std::uint8_t srgb_encode(float display_linear);  // clamps to [0, 1], NaN to 0; rounds to nearest
glm::vec3 srgb_decode(const common::Rgb8& pixel);
common::Rgb8 srgb_encode(const glm::vec3& display_linear);

}  // namespace amalgam::scene
