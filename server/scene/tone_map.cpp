#include "scene/tone_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace amalgam::scene {
namespace {

double decode(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

const std::array<float, 256>& decode_table() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> made{};
    for (std::size_t i = 0; i < made.size(); ++i) {
      made[i] = static_cast<float>(decode(static_cast<double>(i) / 255.0));
    }
    return made;
  }();
  return table;
}

// Largest display-linear value of each byte: rounding to nearest happens in the encoded domain.
const std::array<float, 255>& encode_thresholds() {
  static const std::array<float, 255> thresholds = [] {
    std::array<float, 255> made{};
    for (std::size_t i = 0; i < made.size(); ++i) {
      made[i] = static_cast<float>(decode((static_cast<double>(i) + 0.5) / 255.0));
    }
    return made;
  }();
  return thresholds;
}

}  // namespace

float compress(float x) {
  return x < 1.0f ? x / (1.0f + x) : 1.0f / (1.0f + 1.0f / x);
}

float expand(float d) {
  static const float kMax = static_cast<float>(decode(254.5 / 255.0));
  const float clamped = std::clamp(d, 0.0f, kMax);
  return clamped / (1.0f - clamped);
}

glm::vec3 tone_map(const glm::vec3& scene_linear, float exposure) {
  return {compress(exposure * scene_linear.x), compress(exposure * scene_linear.y),
          compress(exposure * scene_linear.z)};
}

glm::vec3 inverse_tone_map(const glm::vec3& display_linear, float exposure) {
  return glm::vec3(expand(display_linear.x), expand(display_linear.y), expand(display_linear.z)) /
         exposure;
}

float srgb_decode(std::uint8_t byte) {
  return decode_table()[byte];
}

float srgb_decode(float encoded) {
  return static_cast<float>(decode(std::clamp(static_cast<double>(encoded), 0.0, 1.0)));
}

std::uint8_t srgb_encode(float display_linear) {
  const auto& thresholds = encode_thresholds();
  if (!(display_linear > 0.0f)) return 0;  // NaN too
  // A guess by the curve, then at most a step or two along the exact thresholds.
  const float x = std::min(display_linear, 1.0f);
  const float encoded = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
  int byte = std::clamp(static_cast<int>(encoded * 255.0f + 0.5f), 0, 255);
  while (byte > 0 && x < thresholds[static_cast<std::size_t>(byte) - 1]) --byte;
  while (byte < 255 && x >= thresholds[static_cast<std::size_t>(byte)]) ++byte;
  return static_cast<std::uint8_t>(byte);
}

glm::vec3 srgb_decode(const core::Rgb8& pixel) {
  return {srgb_decode(pixel.x), srgb_decode(pixel.y), srgb_decode(pixel.z)};
}

core::Rgb8 srgb_encode(const glm::vec3& display_linear) {
  return {srgb_encode(display_linear.x), srgb_encode(display_linear.y),
          srgb_encode(display_linear.z)};
}

}  // namespace amalgam::scene
