#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "codec/jpeg.h"

// libjpeg does not refuse progressive or arithmetic coding, hence this walk over
// the markers of ITU-T T.81 (annex B).

namespace amalgam::codec {
namespace {

constexpr int kStartOfImage = 0xD8, kEndOfImage = 0xD9, kStartOfScan = 0xDA;

class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  bool at_end() const { return position_ >= bytes_.size(); }

  int u8() {
    if (at_end()) throw JpegError("JPEG ends inside its header");
    return std::to_integer<int>(bytes_[position_++]);
  }
  int u16() {
    const int high = u8();
    return high * 256 + u8();
  }
  void skip(int count) {
    if (bytes_.size() - position_ < static_cast<std::size_t>(count)) {
      throw JpegError("JPEG ends inside a segment");
    }
    position_ += static_cast<std::size_t>(count);
  }

  // The code of the next marker. Fill bytes (0xFF) before it are allowed, and stray ones as libjpeg
  // skips them (it counts and judges them).
  int marker() {
    while (true) {
      while (u8() != 0xFF) continue;
      int code = u8();
      while (code == 0xFF) code = u8();
      if (code != 0) return code;
    }
  }

  // Moves past entropy-coded data, in which 0xFF is followed by 0 or is a restart marker.
  // Leaves the reader at the next real marker, or at the end.
  void skip_entropy_coded() {
    while (!at_end()) {
      const auto rest = bytes_.subspan(position_);
      const auto found = std::find(rest.begin(), rest.end(), std::byte{0xFF});
      position_ += static_cast<std::size_t>(found - rest.begin());
      if (bytes_.size() - position_ < 2) {
        position_ = bytes_.size();
        return;
      }
      const int code = std::to_integer<int>(bytes_[position_ + 1]);
      if (code == 0xFF) {
        ++position_;  // a fill byte
      } else if (code == 0 || (code >= 0xD0 && code <= 0xD7)) {
        position_ += 2;
      } else {
        return;
      }
    }
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
};

bool is_frame_marker(int code) {
  return code >= 0xC0 && code <= 0xCF && code != 0xC4 && code != 0xC8 && code != 0xCC;
}

void refuse_unless_sequential_huffman(int code) {
  switch (code) {
    case 0xC0:
    case 0xC1:
      return;  // baseline, and extended sequential with 8 bits, which differs in table counts only
    case 0xC2:
      throw JpegError("progressive JPEG is not accepted, only baseline");
    case 0xC3:
      throw JpegError("lossless JPEG is not accepted, only baseline");
    case 0xC5:
    case 0xC6:
    case 0xC7:
      throw JpegError("hierarchical JPEG is not accepted, only baseline");
    default:
      throw JpegError("arithmetic-coded JPEG is not accepted, only baseline");
  }
}

struct Sampling {
  int horizontal = 0;
  int vertical = 0;
  bool operator==(const Sampling&) const = default;
};

JpegSubsampling classify(const std::array<Sampling, 3>& components) {
  const auto [luma, blue, red] = components;
  if (blue == red) {
    if (luma == blue) return JpegSubsampling::Yuv444;
    const bool half_width = luma.horizontal == 2 * blue.horizontal;
    if (half_width && luma.vertical == blue.vertical) return JpegSubsampling::Yuv422;
    if (half_width && luma.vertical == 2 * blue.vertical) return JpegSubsampling::Yuv420;
  }
  throw JpegError("JPEG chroma subsampling is none of 4:4:4, 4:2:2, 4:2:0");
}

struct Frame {
  JpegHeader header;
  int components = 0;
};

Frame read_frame(ByteReader& reader, int code) {
  refuse_unless_sequential_huffman(code);
  const int length = reader.u16(), precision = reader.u8();
  if (precision != 8) {
    throw JpegError("JPEG has " + std::to_string(precision) +
                    " bits a sample; only 8 are accepted");
  }
  Frame frame;
  frame.header.height = reader.u16();
  frame.header.width = reader.u16();
  frame.components = reader.u8();
  const int width = frame.header.width, height = frame.header.height;
  if (width < 1 || height < 1 || width > kMaxJpegSide || height > kMaxJpegSide ||
      width * height > kMaxJpegPixels) {
    throw JpegError("JPEG size " + std::to_string(width) + "x" + std::to_string(height) +
                    " is not within 1x1 and " + std::to_string(kMaxJpegSide) + "x" +
                    std::to_string(kMaxJpegSide));
  }
  if (frame.components == 4) throw JpegError("CMYK JPEG is not accepted, only grey and YCbCr");
  if (frame.components != 1 && frame.components != 3) {
    throw JpegError("JPEG has " + std::to_string(frame.components) + " components, not 1 or 3");
  }
  if (length != 8 + 3 * frame.components) throw JpegError("JPEG frame header has a wrong length");

  std::array<Sampling, 3> sampling{};
  for (int i = 0; i < frame.components; ++i) {
    reader.skip(1);  // component id
    const int factors = reader.u8();
    reader.skip(1);  // quantisation table
    Sampling& s = sampling[static_cast<std::size_t>(i)];
    s = {factors >> 4, factors & 15};
    if (s.horizontal < 1 || s.horizontal > 4 || s.vertical < 1 || s.vertical > 4) {
      throw JpegError("JPEG sampling factors are not within 1 and 4");
    }
  }
  frame.header.subsampling = frame.components == 1 ? JpegSubsampling::Grey : classify(sampling);
  return frame;
}

void skip_segment(ByteReader& reader) {
  const int length = reader.u16();
  if (length < 2) throw JpegError("JPEG segment has a length below 2");
  reader.skip(length - 2);
}

}  // namespace

JpegHeader read_jpeg_header(std::span<const std::byte> jpeg) {
  ByteReader reader(jpeg);
  if (jpeg.size() < 2 || reader.u8() != 0xFF || reader.u8() != kStartOfImage) {
    throw JpegError("not a JPEG: it does not begin with FF D8");
  }
  std::optional<Frame> frame;
  int scans = 0;
  while (!reader.at_end()) {
    const int code = reader.marker();
    if (code == kEndOfImage) break;
    if (is_frame_marker(code)) {
      if (frame) throw JpegError("JPEG has two frame headers");
      frame = read_frame(reader, code);
    } else if (code == kStartOfScan) {
      if (!frame) throw JpegError("JPEG has a scan before its frame header");
      // Each scan costs a pass over the whole picture: as many as there are components are
      // legitimate.
      if (++scans > frame->components) throw JpegError("JPEG has more scans than components");
      skip_segment(reader);
      reader.skip_entropy_coded();
    } else if (code == 0xCC) {
      throw JpegError("arithmetic-coded JPEG is not accepted, only baseline");
    } else if (code == 0x01 || (code >= 0xD0 && code <= 0xD8)) {
      throw JpegError("JPEG has a marker that may not stand here");
    } else {
      skip_segment(reader);
    }
  }
  if (!frame) throw JpegError("JPEG has no frame header");
  if (scans == 0) throw JpegError("JPEG has no scan");
  return frame->header;
}

}  // namespace amalgam::codec
