// JPEGs of every kind a camera may send, and what is in a JPEG: made and read with libjpeg itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/image.h"

namespace amalgam::tests {

using Bytes = std::vector<std::byte>;

enum class SampleColor { Grey, YCbCr, Rgb };

struct SampleKind {
  SampleColor color = SampleColor::YCbCr;
  std::array<int, 2> luma{2, 2};  // sampling factors, horizontal and vertical
  std::array<int, 2> chroma{1, 1};
  int quality = 90;
  int restart_interval = 0;  // MCUs
  bool scan_for_each_component = false;
  std::array<int, 3> ids{1, 2, 3};
  bool jfif = true;
  int bright_dc = 0;  // if not 0, the DC coefficient of all blocks, possible or not
};

Bytes sample_jpeg(const common::ImageRgb8& image, const SampleKind& kind);

// The file with an application segment (marker FF E0 + number) put after its first marker.
Bytes with_segment(const Bytes& jpeg, int number, std::span<const char> content);

// Noise on a gradient: all coefficients of all blocks have something to tell. Differs by seed.
common::ImageRgb8 noisy_picture(int width, int height, unsigned seed, bool grey = false);

struct ComponentBlocks {
  int across = 0;  // blocks
  int down = 0;    // blocks
  int per_mcu_x = 0;
  int per_mcu_y = 0;
  std::array<std::uint16_t, 64> quantisation{};
  std::vector<std::array<std::int16_t, 64>> blocks;  // row by row
};

std::vector<ComponentBlocks> blocks_of(const Bytes& jpeg);

// Decoded with each chroma sample repeated, not smoothed over its neighbours.
common::ImageRgb8 decode_unsmoothed(const Bytes& jpeg);

}  // namespace amalgam::tests
