// Three 8-bit channels in one word, so that the synthetic camera filters two of them at a time.
#pragma once

#include <cstdint>

#include "core/image.h"

namespace amalgam::client {

using PackedColour = std::uint32_t;  // 0x00BBGGRR, sRGB values

inline constexpr PackedColour kRedAndBlue = 0x00FF00FF;
inline constexpr PackedColour kGreen = 0x0000FF00;

inline constexpr PackedColour pack(const core::Rgb8& colour) {
  return colour.r | static_cast<PackedColour>(colour.g) << 8 |
         static_cast<PackedColour>(colour.b) << 16;
}

// weight 0..256: from a to b. Truncates: at most 1 below the exact value.
inline constexpr PackedColour mix_packed(PackedColour a, PackedColour b, std::uint32_t weight) {
  const std::uint32_t rest = 256 - weight;
  const PackedColour red_blue = ((a & kRedAndBlue) * rest + (b & kRedAndBlue) * weight) >> 8;
  const PackedColour green = ((a & kGreen) * rest + (b & kGreen) * weight) >> 8;
  return (red_blue & kRedAndBlue) | (green & kGreen);
}

// The rounded mean of a number of colours that is known beforehand, at most 256 of them.
template <std::uint32_t Count>
class PackedMean {
 public:
  void add(PackedColour colour) {
    red_blue_ += colour & kRedAndBlue;
    green_ += (colour & kGreen) >> 8;
  }
  core::Rgb8 mean() const {
    return {rounded(red_blue_ & 0xFFFF), rounded(green_), rounded(red_blue_ >> 16)};
  }

 private:
  static std::uint8_t rounded(std::uint32_t sum) {
    return static_cast<std::uint8_t>((sum + Count / 2) / Count);
  }

  std::uint32_t red_blue_ = 0, green_ = 0;
};

}  // namespace amalgam::client
