#include "codec/jpeg_metadata.h"

#include <gtest/gtest.h>

#include <string_view>

#include "codec/jpeg.h"
#include "unit/codec/jpeg_samples.h"

namespace amalgam::codec {
namespace {

using namespace std::string_view_literals;
using tests::Bytes;
using tests::with_segment;

const common::ImageRgb8 kPicture(24, 16, common::Rgb8(200, 100, 50));

// With the segments in this order: what is inserted first comes last.
Bytes camera_jpeg() {
  Bytes jpeg = encode_jpeg(kPicture, 90);
  jpeg = with_segment(jpeg, 2, "MPF\0offsets of a larger picture"sv);
  jpeg = with_segment(jpeg, 1, "something else"sv);
  jpeg = with_segment(jpeg, 2, "ICC_PROFILE\0\1\1what red is"sv);
  return with_segment(jpeg, 1, "Exif\0\0II*\0orientation 6"sv);
}

TEST(JpegMetadata, ExifAndProfileAreFoundAndNothingElse) {
  const Bytes expected = with_segment(with_segment(Bytes(2), 2, "ICC_PROFILE\0\1\1what red is"sv),
                                      1, "Exif\0\0II*\0orientation 6"sv);
  EXPECT_EQ(jpeg_metadata(camera_jpeg()), Bytes(expected.begin() + 2, expected.end()));
  EXPECT_TRUE(jpeg_metadata(encode_jpeg(kPicture, 90)).empty());
}

TEST(JpegMetadata, SurvivesInAnotherFile) {
  Bytes composite = encode_jpeg(kPicture, 80);
  const common::ImageRgb8 before = decode_jpeg(composite);
  insert_metadata(composite, jpeg_metadata(camera_jpeg()));
  EXPECT_EQ(jpeg_metadata(composite), jpeg_metadata(camera_jpeg()));
  EXPECT_EQ(decode_jpeg(composite), before);
}

// Readers expect JFIF's header first.
TEST(JpegMetadata, StandsBehindTheJfifHeader) {
  Bytes composite = encode_jpeg(kPicture, 80);
  insert_metadata(composite, jpeg_metadata(camera_jpeg()));
  EXPECT_EQ(composite[3], std::byte{0xE0});
}

TEST(JpegMetadata, StrayBytesBeforeAMarkerAreSkipped) {
  Bytes camera = camera_jpeg();
  camera.insert(camera.begin() + 2, {std::byte{7}, std::byte{0xFF}, std::byte{0}});
  EXPECT_EQ(jpeg_metadata(camera), jpeg_metadata(camera_jpeg()));
}

TEST(JpegMetadata, TruncationsAreRead) {
  const Bytes camera = camera_jpeg();
  for (std::size_t size = 0; size < camera.size(); ++size) {
    EXPECT_LE(jpeg_metadata(std::span(camera).first(size)).size(), size);
  }
}

}  // namespace
}  // namespace amalgam::codec
