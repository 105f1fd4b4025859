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
