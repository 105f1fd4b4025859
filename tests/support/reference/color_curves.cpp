#include "support/reference/color_curves.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace amalgam::reference {

double srgb_decode(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double srgb_encode(double display_linear) {
  return display_linear <= 0.0031308 ? 12.92 * display_linear
                                     : 1.055 * std::pow(display_linear, 1.0 / 2.4) - 0.055;
}

double srgb_decode_byte(std::uint8_t byte) {
  static const std::array<double, 256> table = [] {
    std::array<double, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = srgb_decode(static_cast<double>(i) / 255.0);
    }
    return values;
  }();
  return table[byte];
}

std::uint8_t srgb_encode_byte(double display_linear) {
  const double clamped = std::clamp(display_linear, 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(255.0 * srgb_encode(clamped)));
}

Color tone_map(const Color& scene_linear, const Response& response) {
  const Color x = response.exposure * scene_linear;
  return response.linear ? glm::min(x, Color(1.0)) : x / (1.0 + x);
}

Color inverse_tone_map(const Color& display_linear, const Response& response) {
  if (response.linear) return glm::clamp(display_linear, 0.0, 1.0) / response.exposure;
  static const double ceiling = srgb_decode(254.5 / 255.0);
  const Color d = glm::clamp(display_linear, Color(0.0), Color(ceiling));
  return d / (1.0 - d) / response.exposure;
}

}  // namespace amalgam::reference
