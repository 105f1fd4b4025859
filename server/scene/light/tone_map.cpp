#include "scene/light/tone_map.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <stdexcept>
#include <string>

namespace amalgam::scene {
namespace {

double decode(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::array<float, 256> make_decode_table() {
  std::array<float, 256> made{};
  for (std::size_t i = 0; i < made.size(); ++i) {
    made[i] = static_cast<float>(decode(static_cast<double>(i) / 255.0));
  }
  return made;
}

// The byte of a display-linear value is the number of thresholds that are not above it: rounding to
// nearest happens in the encoded domain. The thresholds are 1.5e-4 to 0.996, and no two of them lie
// in one bucket of floats that have the first kBucketBits bits of their mantissa in common. So a
// look-up gives the byte at the bucket's begin, and one comparison says whether it is the next one.
class SrgbEncoder {
 public:
  SrgbEncoder() {
    for (std::size_t i = 0; i < kBytes - 1; ++i) {
      next_[i] = static_cast<float>(decode((static_cast<double>(i) + 0.5) / 255.0));
    }
    next_[kBytes - 1] = std::numeric_limits<float>::infinity();
    std::size_t byte = 0;
    for (std::uint32_t bucket = 0; bucket < kBuckets; ++bucket) {
      const float begin = std::bit_cast<float>(kFirst + (bucket << kDroppedBits));
      while (begin >= next_[byte]) ++byte;
      first_[bucket] = static_cast<std::uint8_t>(byte);
    }
  }

  std::uint8_t operator()(float display_linear) const {
    // NaN becomes kLeast, as the comparison with it is false.
    const float x = display_linear > kLeast ? std::min(display_linear, 1.0f) : kLeast;
    const std::uint32_t bucket = (std::bit_cast<std::uint32_t>(x) - kFirst) >> kDroppedBits;
    const std::uint8_t byte = first_[bucket];
    return static_cast<std::uint8_t>(byte + (x >= next_[byte] ? 1 : 0));
  }

 private:
  static constexpr std::size_t kBytes = 256;
  static constexpr int kBucketBits = 7, kDroppedBits = 23 - kBucketBits;
  static constexpr float kLeast = 0x1p-13f;  // below the first threshold
  static constexpr std::uint32_t kFirst = std::bit_cast<std::uint32_t>(kLeast);
  // One for 1.0 itself.
  static constexpr std::uint32_t kBuckets =
      ((std::bit_cast<std::uint32_t>(1.0f) - kFirst) >> kDroppedBits) + 1;

  std::array<std::uint8_t, kBuckets> first_{};  // the byte at a bucket's begin
  std::array<float, kBytes> next_{};            // where the byte after each begins
};

// Made before main(), so that the loops over pixels do not ask each time whether they are there.
const std::array<float, 256> kDecodeTable = make_decode_table();
const SrgbEncoder kEncoder;

}  // namespace

float compress(float x) {
  return x < 1.0f ? x / (1.0f + x) : 1.0f / (1.0f + 1.0f / x);
}

float expand(float d) {
  static const float kMax = static_cast<float>(decode(254.5 / 255.0));
  const float clamped = std::clamp(d, 0.0f, kMax);
  return clamped / (1.0f - clamped);
}

ToneCurve parse_tone_curve(std::string_view text) {
  for (const ToneCurve curve : kToneCurves) {
    if (text == tone_curve_name(curve)) return curve;
  }
  throw std::invalid_argument("tone map '" + std::string(text) +
                              "' is neither reinhard nor linear");
}

const char* tone_curve_name(ToneCurve curve) {
  return curve == ToneCurve::Linear ? "linear" : "reinhard";
}

glm::vec3 tone_map(const glm::vec3& scene_linear, const ToneMap& tone_map) {
  const glm::vec3 exposed = tone_map.exposure * scene_linear;
  if (tone_map.curve == ToneCurve::Linear) return glm::min(exposed, glm::vec3(1.0f));
  return {compress(exposed.x), compress(exposed.y), compress(exposed.z)};
}

glm::vec3 inverse_tone_map(const glm::vec3& display_linear, const ToneMap& tone_map) {
  const glm::vec3& d = display_linear;
  const glm::vec3 exposed = tone_map.curve == ToneCurve::Linear
                                ? glm::clamp(d, 0.0f, 1.0f)
                                : glm::vec3(expand(d.x), expand(d.y), expand(d.z));
  return exposed / tone_map.exposure;
}

glm::vec3 tone_map_step(const glm::vec3& a, const glm::vec3& b, const ToneMap& tone_map) {
  const glm::vec3& e = tone_map.exposure;
  if (tone_map.curve == ToneCurve::Linear) {
    return glm::min(e * b, glm::vec3(1.0f)) - glm::min(e * a, glm::vec3(1.0f));
  }
  // One division instead of two.
  return e * (b - a) / ((1.0f + e * a) * (1.0f + e * b));
}

float srgb_decode(std::uint8_t byte) {
  return kDecodeTable[byte];
}

float srgb_decode(float encoded) {
  return static_cast<float>(decode(std::clamp(static_cast<double>(encoded), 0.0, 1.0)));
}

std::uint8_t srgb_encode(float display_linear) {
  return kEncoder(display_linear);
}

glm::vec3 srgb_decode(const common::Rgb8& pixel) {
  return {srgb_decode(pixel.x), srgb_decode(pixel.y), srgb_decode(pixel.z)};
}

common::Rgb8 srgb_encode(const glm::vec3& display_linear) {
  return {kEncoder(display_linear.x), kEncoder(display_linear.y), kEncoder(display_linear.z)};
}

}  // namespace amalgam::scene
