// Camera frames and composites as JPEG, by libjpeg's own interface (codec/libjpeg.h): turbojpeg's
// gives no restart markers and does not tell one warning from another.
//
// Bytes come from strangers. So our own bounded parser checks the header before the library sees
// anything, and a picture is either decoded whole or refused.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

#include "common/image.h"

namespace amalgam::codec {

// What was wrong with the bytes, in one line.
class JpegError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class JpegSubsampling { Grey, Yuv444, Yuv422, Yuv420 };

struct JpegHeader {
  int width = 0;   // pixels, 1 .. kMaxJpegSide
  int height = 0;  // pixels, 1 .. kMaxJpegSide; width * height <= kMaxJpegPixels
  JpegSubsampling subsampling = JpegSubsampling::Yuv420;
};

constexpr int kMaxJpegSide = 2048;           // pixels
constexpr int kMaxJpegPixels = 2048 * 2048;  // 4 Mpixel

// Reads up to the end of the last scan's header, decoding nothing, in time linear in the number of
// bytes. Throws JpegError unless this is one sequential Huffman-coded 8-bit picture, grey or of
// three components in one of the four subsamplings above, within the size limits, with no more
// scans than components. Errors name what is refused: progressive, lossless, hierarchical,
// arithmetic, 12-bit, CMYK.
JpegHeader read_jpeg_header(std::span<const std::byte> jpeg);

// Decodes to sRGB-encoded bytes; grey becomes equal channels. Throws JpegError as
// read_jpeg_header() does, and at the library's first warning (truncated or damaged data) but for
// one: a few stray bytes before a marker, which many webcams write. So no broken picture is shown,
// and no pixels that an earlier picture left in memory.
common::ImageRgb8 decode_jpeg(std::span<const std::byte> jpeg);

// Quality 1 .. 100. Chroma is halved in both directions (4:2:0) below quality 95 and kept (4:4:4)
// from there on. Bands of the image are encoded on all cores of the caller's TBB arena; the bytes
// do not depend on their number. Throws JpegError if the image is empty or larger than 65500 a
// side, or quality is out of range.
std::vector<std::byte> encode_jpeg(const common::ImageRgb8& image, int quality);

}  // namespace amalgam::codec
