// Encodes a composite as a patch: the camera's own JPEG with the changed blocks replaced.
//
// A JPEG is a grid of MCUs (minimum coded units: 16x16 pixels for 4:2:0, 16x8 for 4:2:2, 8x8 for
// 4:4:4 and grey), each a few blocks of quantised DCT coefficients. Patching copies the
// coefficients of every MCU without a changed pixel, bit for bit. It encodes the others from the
// composite with the camera's quantisation tables. So an untouched pixel is not quantised twice.
//
// Bit-equal coefficients give bit-equal pixels, with one exception. Decoders smooth the halved
// chroma of 4:2:0 and 4:2:2 across the borders of MCUs ("fancy upsampling"), so the outermost
// pixels of an untouched MCU beside a touched one may change a little when decoded.
//
// In two steps. The first needs only the camera's bytes and can run on another thread while the
// frame is rendered:
//
//   std::optional<JpegCoefficients> camera = JpegCoefficients::read(jpeg);    // early, anywhere
//   ...
//   std::optional<std::vector<std::byte>> out;
//   if (camera) out = patch_jpeg(*std::move(camera), composite, tiles);
//   if (!out) out = encode_jpeg(composite, quality);
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "codec/jpeg.h"
#include "common/image.h"

namespace amalgam::codec {

struct CameraJpeg;

// A camera JPEG's coefficients, and its Huffman code rewritten so that it can be cut. Does not
// refer to the original bytes. Takes 2 bytes a sample (24 MiB at the limits of read_jpeg_header())
// plus about the size of the file.
class JpegCoefficients {
 public:
  // Throws JpegError for what decode_jpeg() refuses, at the first warning too. Empty where the
  // picture is good but cannot be patched faithfully, so that the whole composite must be encoded:
  // - its three components are not YCbCr (an Adobe marker or the component names say RGB),
  // - a quantisation table is missing, used with two contents, or not within 1 and 255,
  // - a coefficient is larger than an 8-bit picture can have,
  // - an MCU has more than ten blocks (sampling factors with a common divisor, which need not be).
  static std::optional<JpegCoefficients> read(std::span<const std::byte> jpeg);

  JpegCoefficients(JpegCoefficients&&) noexcept;
  JpegCoefficients& operator=(JpegCoefficients&&) noexcept;
  ~JpegCoefficients();

  const JpegHeader& header() const;

 private:
  friend std::optional<std::vector<std::byte>> patch_jpeg(JpegCoefficients camera,
                                                          const common::ImageRgb8& composite,
                                                          std::span<const std::uint8_t> tiles);

  explicit JpegCoefficients(std::unique_ptr<CameraJpeg> camera);

  std::unique_ptr<CameraJpeg> camera_;
};

constexpr int kPatchTile = 16;  // pixels a side

// composite: sRGB-encoded, of the camera's size (checked). tiles: a flag for each tile of
// kPatchTile x kPatchTile pixels, row by row, ceil(width / kPatchTile) in a row; not 0 where a
// pixel changed. Every MCU that overlaps a flagged tile is encoded from the composite; the others
// are the camera's. Takes time in proportion to the changed area, on all cores of the caller's TBB
// arena; the bytes do not depend on their number.
//
// Empty if the camera's picture is grey and a touched MCU of the composite is colored.
//
// The result is baseline, one scan, with a restart marker after each 96 pixels or a little more
// (about 1 % of the bytes), so that segments can be replaced without coding the rest again. The
// camera's metadata (codec/jpeg_metadata.h) are kept and a JFIF header is written (it says YCbCr,
// as an Adobe marker would); everything else is left out. Huffman tables are the standard ones: the
// file's own may lack codes that new coefficients need, and optimal ones need a second pass over
// everything.
std::optional<std::vector<std::byte>> patch_jpeg(JpegCoefficients camera,
                                                 const common::ImageRgb8& composite,
                                                 std::span<const std::uint8_t> tiles);

}  // namespace amalgam::codec
