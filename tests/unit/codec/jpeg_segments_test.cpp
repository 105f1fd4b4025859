#include "codec/jpeg_segments.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "codec/jpeg.h"
#include "jpeg_samples.h"

namespace amalgam::codec {
namespace {

using tests::Bytes;
using tests::noisy_picture;

TEST(JpegSegments, CuttingAndJoiningGivesTheSameBytes) {
  const Bytes file = tests::sample_jpeg(noisy_picture(160, 160, 1), {.restart_interval = 5});
  const SegmentedJpeg cut(file);
  ASSERT_EQ(cut.count(), 20u);  // more than there are restart markers to take turns
  std::vector<JpegSegment> segments;
  for (std::size_t i = 0; i < cut.count(); ++i) segments.push_back(cut.segment(i));
  EXPECT_EQ(join_segments(cut.head(), segments), file);
}

TEST(JpegSegments, AFileWithoutRestartMarkersIsOneSegment) {
  const Bytes file = tests::sample_jpeg(noisy_picture(50, 40, 1), {});
  const SegmentedJpeg cut(file);
  ASSERT_EQ(cut.count(), 1u);
  EXPECT_EQ(cut.head().size() + cut.segment(0).size() + 2, file.size());
}

TEST(JpegSegments, SegmentsCanChangePlaces) {
  const Bytes file = tests::sample_jpeg(noisy_picture(32, 16, 1), {.restart_interval = 1});
  const SegmentedJpeg cut(file);
  const JpegSegment swapped[]{cut.segment(1), cut.segment(0)};
  const auto before = tests::decode_unsmoothed(file);
  const auto after = tests::decode_unsmoothed(join_segments(cut.head(), swapped));
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 32; ++x) ASSERT_EQ(after.at(x, y), before.at((x + 16) % 32, y));
  }
}

TEST(JpegSegments, HeightCanBeSet) {
  Bytes file = tests::sample_jpeg(noisy_picture(16, 16, 1), {});
  set_height(file, 700);
  EXPECT_EQ(read_jpeg_header(file).height, 700);
}

// Encoding in bands makes the picture that encoding in one piece makes.
TEST(JpegEncode, BandsDoNotShow) {
  for (const glm::ivec2& size : {glm::ivec2(1, 1), {200, 64}, {61, 65}, {97, 331}, {300, 256}}) {
    for (const int quality : {30, 90, 95}) {
      const common::ImageRgb8 image = noisy_picture(size.x, size.y, 1);
      const int sampling = quality < 95 ? 2 : 1;
      const Bytes whole =
          tests::sample_jpeg(image, {.luma = {sampling, sampling}, .quality = quality});
      const auto expected = tests::blocks_of(whole);
      const Bytes file = encode_jpeg(image, quality);
      const auto blocks = tests::blocks_of(file);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(blocks[c].quantisation, expected[c].quantisation);
        EXPECT_EQ(blocks[c].blocks, expected[c].blocks)
            << size.x << "x" << size.y << " at " << quality;
      }
      EXPECT_EQ(decode_jpeg(file), decode_jpeg(whole));
    }
  }
}

}  // namespace
}  // namespace amalgam::codec
