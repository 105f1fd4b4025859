// Pictures of scenes: PNG, JPEG and WebP textures and environment maps. The only user of stb_image
// and libwebp.
// Unlike camera frames (codec/jpeg.h) they come from the operator.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <stdexcept>

#include "common/image.h"

namespace amalgam::codec {

class PictureError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

constexpr int kMaxPictureSide = 8192;                // pixels
constexpr int kMaxPicturePixels = 32 * 1024 * 1024;  // 32 Mpixel

// Whether the bytes begin like a PNG, JPEG or WebP.
bool is_picture(std::span<const std::byte> encoded);

// Throws PictureError unless the bytes begin like a PNG, JPEG or WebP within the limits and, for a
// PNG, are complete.
void check_picture(std::span<const std::byte> encoded);

// PNG, JPEG (progressive too) or still WebP to sRGB-encoded bytes with linear alpha, 255 where the
// file has none. 16-bit channels are reduced to 8. The size is checked before anything is decoded.
common::ImageRgba8 decode_picture(std::span<const std::byte> encoded);

// Throws PictureError for a size outside the limits.
void check_picture_size(const glm::ivec2& size);

}  // namespace amalgam::codec
