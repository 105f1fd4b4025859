// Three 8-bit channels in one word, so that the synthetic camera filters two of them at a time.
#pragma once

#include <cstdint>

#include "common/image.h"

namespace amalgam::client {

using PackedColor = std::uint32_t;  // 0x00BBGGRR, sRGB values

inline constexpr PackedColor kRedAndBlue = 0x00FF00FF;
inline constexpr PackedColor kGreen = 0x0000FF00;

inline constexpr PackedColor pack(const common::Rgb8& color) {
  return color.r | static_cast<PackedColor>(color.g) << 8 | static_cast<PackedColor>(color.b) << 16;
}

// weight 0..256: from a to b. Truncates: at most 1 below the exact value.
inline constexpr PackedColor mix_packed(PackedColor a, PackedColor b, std::uint32_t weight) {
  const std::uint32_t rest = 256 - weight;
  const PackedColor red_blue = ((a & kRedAndBlue) * rest + (b & kRedAndBlue) * weight) >> 8;
  const PackedColor green = ((a & kGreen) * rest + (b & kGreen) * weight) >> 8;
  return (red_blue & kRedAndBlue) | (green & kGreen);
}

// The rounded mean of exactly Count colors, at most 256.
template <std::uint32_t Count>
class PackedMean {
 public:
  void add(PackedColor color) {
    red_blue_ += color & kRedAndBlue;
    green_ += (color & kGreen) >> 8;
  }
  common::Rgb8 mean() const {
    return {rounded(red_blue_ & 0xFFFF), rounded(green_), rounded(red_blue_ >> 16)};
  }

 private:
  static std::uint8_t rounded(std::uint32_t sum) {
    return static_cast<std::uint8_t>((sum + Count / 2) / Count);
  }

  std::uint32_t red_blue_ = 0, green_ = 0;
};

}  // namespace amalgam::client
