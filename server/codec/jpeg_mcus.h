// The division of a JPEG: pixels into MCUs, MCUs into the segments that patching replaces.
#pragma once

#include <array>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "codec/libjpeg.h"
#include "common/image.h"

namespace amalgam::codec {

// MCUs are numbered row by row from the top left. A segment is `segment` consecutive MCUs.
struct McuGrid {
  explicit McuGrid(const jpeg_decompress_struct& info);

  int count() const { return across * down; }
  int segments() const { return count() / segment; }

  // Of an MCU: its column and row; its first pixel; one past its last pixel inside the picture.
  glm::ivec2 place(int index) const { return {index % across, index / across}; }
  glm::ivec2 begin(int index) const { return place(index) * size; }
  glm::ivec2 end(int index) const { return glm::min(begin(index) + size, picture); }

  glm::ivec2 picture;                  // pixels
  std::array<glm::ivec2, 3> blocks{};  // columns and rows of each component in an MCU
  glm::ivec2 size;                     // of an MCU, pixels
  int across = 0;                      // MCUs
  int down = 0;                        // MCUs
  int segment = 0;                     // MCUs, divides count()
};

// Encodes the given segments of the picture below each other, as a file that is one segment wide.
// It has a restart marker after each segment, and the camera's quantisation tables and sampling.
std::vector<std::byte> encode_segments(jpeg_decompress_struct& camera, const McuGrid& grid,
                                       const common::ImageRgb8& picture,
                                       std::span<const int> segments);

// Huffman-codes all of the reader's coefficients, with the standard tables and a restart marker
// after each `interval` MCUs. Keeps color profiles.
std::vector<std::byte> write_coefficients(CoefficientReader& from, int interval);

}  // namespace amalgam::codec
