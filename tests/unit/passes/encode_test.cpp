#include "passes/image/encode.h"

#include <gtest/gtest.h>

#include <string_view>

#include "codec/jpeg.h"
#include "codec/jpeg_metadata.h"

namespace amalgam::passes {
namespace {

using namespace std::string_view_literals;

std::vector<std::byte> bytes_of(std::string_view text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

std::vector<std::byte> encode(const common::ImageRgb8& picture, int quality,
                              const EncodedOrPixels& camera) {
  graph::FrameGraph graph;
  const auto encoded = add_encode_pass(
      graph, {.composite = graph.import("composite", Composite{picture, {}}),
              .coefficients = graph.absent<CameraCoefficients>("coefficients", "another quality"),
              .quality = quality,
              .camera = &camera});
  return graph.realise(encoded)->jpeg;
}

// A client that asks for a quality gets a new JPEG. Without the camera's orientation its view would
// turn by 90 degrees as soon as something virtual is in it.
TEST(Encode, AQualityOfOnesOwnKeepsTheCamerasMetadata) {
  const common::ImageRgb8 picture(32, 16, common::Rgb8(200, 100, 50));
  const std::vector<std::byte> orientation_6 = bytes_of(
      "\xFF\xE1\0\x22"
      "Exif\0\0II*\0\10\0\0\0\1\0\x12\1\3\0\1\0\0\0\6\0\0\0\0\0\0\0"sv);
  std::vector<std::byte> from_camera = codec::encode_jpeg(picture, 90);
  codec::insert_metadata(from_camera, orientation_6);
  ASSERT_EQ(codec::jpeg_metadata(from_camera), orientation_6);

  const auto jpeg = encode(picture, 40, from_camera);
  EXPECT_EQ(codec::jpeg_metadata(jpeg), orientation_6);
  // Nothing else differs from a JPEG of that quality.
  std::vector<std::byte> expected = codec::encode_jpeg(picture, 40);
  codec::insert_metadata(expected, orientation_6);
  EXPECT_EQ(jpeg, expected);
}

TEST(Encode, PixelsWithoutAFileHaveNoMetadata) {
  const common::ImageRgb8 picture(32, 16, common::Rgb8(200, 100, 50));
  EXPECT_EQ(encode(picture, 40, picture), codec::encode_jpeg(picture, 40));
}

}  // namespace
}  // namespace amalgam::passes
