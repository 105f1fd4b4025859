#include "codec/picture.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>

#include "codec/jpeg.h"

namespace amalgam::codec {
namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes_of(const std::string& text) {
  const auto* data = reinterpret_cast<const std::byte*>(text.data());
  return {data, data + text.size()};
}

Bytes read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return bytes_of({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
}

const std::string kMarble = AMALGAM_SOURCE_DIR "/deploy/scenes/marble.png";

TEST(Picture, ReadsPng) {
  const common::ImageRgba8 image = decode_picture(read(kMarble));
  EXPECT_EQ(image.size(), glm::ivec2(128, 128));
  EXPECT_EQ(image.at(5, 7).w, 255);
}

TEST(Picture, ReadsJpeg) {
  const Bytes jpeg = encode_jpeg(common::ImageRgb8(20, 10, common::Rgb8(200, 30, 40)), 95);
  const common::ImageRgba8 image = decode_picture(jpeg);
  EXPECT_EQ(image.size(), glm::ivec2(20, 10));
  EXPECT_NEAR(image.at(3, 3).x, 200, 3);
}

TEST(Picture, RefusesEveryTruncationOfAPng) {
  const Bytes png = read(kMarble);
  ASSERT_GT(png.size(), 1000u);
  for (std::size_t size = 0; size < png.size(); size += 37) {
    EXPECT_THROW(decode_picture(std::span(png).first(size)), PictureError) << size;
  }
}

TEST(Picture, RefusesLargeSizesBeforeDecoding) {
  Bytes png = read(kMarble);
  png[16] = std::byte{1};  // width 2^24 + 128, big-endian at byte 16
  EXPECT_THROW(check_picture(png), PictureError);
}

// Bits from the lowest of each byte on, as deflate has them (RFC 1951).
class BitWriter {
 public:
  // The first bit of a code is its highest.
  void put_code(unsigned code, int bits) {
    for (int i = bits; i-- > 0;) put((code >> i & 1u) != 0);
  }
  std::string text() const { return text_; }

 private:
  void put(bool bit) {
    if (used_ % 8 == 0) text_ += '\0';
    if (bit) text_.back() = static_cast<char>(text_.back() | 1 << used_ % 8);
    ++used_;
  }
  std::string text_;
  int used_ = 0;
};

// 258 n + 1 zeros by zlib, in 13 n bits and some.
std::string deflated_zeros(int n) {
  BitWriter bits;
  bits.put_code(0b110, 3);  // the last block, with fixed codes
  bits.put_code(0b00110000, 8);
  for (int i = 0; i < n; ++i) {
    bits.put_code(0b11000101, 8);  // a copy of 258 bytes
    bits.put_code(0, 5);           // of the byte before
  }
  bits.put_code(0, 7);
  return "\x78\x01" + bits.text() + std::string(4, '\0');  // stb_image reads no check sum
}

std::string u32(std::size_t n) {
  return {static_cast<char>(n >> 24 & 255), static_cast<char>(n >> 16 & 255),
          static_cast<char>(n >> 8 & 255), static_cast<char>(n & 255)};
}

Bytes png_of(std::size_t width, std::size_t height, const std::string& kind,
             const std::string& data) {
  const auto chunk = [](const std::string& type, const std::string& content) {
    return u32(content.size()) + type + content + u32(0);
  };
  return bytes_of("\x89PNG\r\n\x1A\n" + chunk("IHDR", u32(width) + u32(height) + kind) +
                  chunk("IDAT", data) + chunk("IEND", ""));
}

// A picture of one texel whose data inflate to 2.6 MB. Some bytes too many are usual.
TEST(Picture, APngInflatesOnlyAsFarAsItsSizeNeeds) {
  const std::string grey{8, 0, 0, 0, 0};
  EXPECT_EQ(decode_picture(png_of(1, 1, grey, deflated_zeros(4))).at(0, 0),
            common::Rgba8(0, 0, 0, 255));
  EXPECT_THROW(decode_picture(png_of(1, 1, grey, deflated_zeros(10'000))), PictureError);
}

// The largest that a right file needs: 16 bits, four channels, interlaced.
TEST(Picture, TheLargestKindOfPngHasRoom) {
  const std::string largest{16, 6, 0, 0, 1};
  for (const std::size_t side : {1u, 30u, 500u}) {
    const std::size_t bytes = 8 * side * side + 2 * side + 8;
    const Bytes png =
        png_of(side, side, largest, deflated_zeros(static_cast<int>(bytes / 258) + 1));
    EXPECT_EQ(decode_picture(png).size(), glm::ivec2(static_cast<int>(side))) << side;
  }
}

TEST(Picture, RefusesOtherKinds) {
  EXPECT_FALSE(is_picture(bytes_of("GIF89a")));
  EXPECT_THROW(decode_picture(bytes_of("GIF89a")), PictureError);
  EXPECT_THROW(decode_picture({}), PictureError);
}

// Each scan costs a pass over the whole picture.
TEST(Picture, RefusesAJpegWithVeryManyScans) {
  Bytes jpeg = encode_jpeg(common::ImageRgb8(20, 10, common::Rgb8(200, 30, 40)), 95);
  EXPECT_NO_THROW(check_picture(jpeg));
  for (int i = 0; i < 1000; ++i) jpeg.insert(jpeg.end(), {std::byte{0xFF}, std::byte{0xDA}});
  EXPECT_THROW(check_picture(jpeg), PictureError);
}

}  // namespace
}  // namespace amalgam::codec
