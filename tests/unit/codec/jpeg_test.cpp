#include "codec/jpeg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include "codec/jpeg_patch.h"
#include "support/damaged_jpeg.h"
#include "support/test_data.h"

namespace amalgam::codec {
namespace {

using Bytes = std::vector<std::byte>;
using test_support::frame_marker;
using test_support::with_more_scans;
using test_support::with_size;

common::ImageRgb8 gradient(int width, int height) {
  common::ImageRgb8 image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = common::Rgb8(255 * x / width, 255 * y / height, 128);
    }
  }
  return image;
}

Bytes with_byte(Bytes jpeg, std::size_t at, int value) {
  jpeg[at] = static_cast<std::byte>(value);
  return jpeg;
}

std::string refusal(const Bytes& jpeg) {
  try {
    read_jpeg_header(jpeg);
  } catch (const JpegError& error) {
    return error.what();
  }
  return "accepted";
}

Bytes read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const auto* data = reinterpret_cast<const std::byte*>(text.data());
  return {data, data + text.size()};
}

std::vector<Bytes> files_in(const std::filesystem::path& folder) {
  std::vector<Bytes> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(read_file(entry.path()));
  }
  return files;
}

TEST(Jpeg, RoundTripStaysClose) {
  const common::ImageRgb8 image = gradient(61, 43);
  const common::ImageRgb8 decoded = decode_jpeg(encode_jpeg(image, 95));
  ASSERT_EQ(decoded.size(), image.size());
  int largest = 0;
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      largest = std::max(largest, std::abs(image.pixels()[i][c] - decoded.pixels()[i][c]));
    }
  }
  EXPECT_LE(largest, 6);  // quality 95 of a smooth picture
}

TEST(Jpeg, HeaderTellsSizeAndSubsampling) {
  const JpegHeader low = read_jpeg_header(encode_jpeg(gradient(61, 43), 80));
  EXPECT_EQ(low.width, 61);
  EXPECT_EQ(low.height, 43);
  EXPECT_EQ(low.subsampling, JpegSubsampling::Yuv420);
  EXPECT_EQ(read_jpeg_header(encode_jpeg(gradient(8, 8), 94)).subsampling, JpegSubsampling::Yuv420);
  EXPECT_EQ(read_jpeg_header(encode_jpeg(gradient(8, 8), 95)).subsampling, JpegSubsampling::Yuv444);
}

TEST(Jpeg, RefusesAtTheHeaderAndSaysWhy) {
  const Bytes good = encode_jpeg(gradient(16, 16), 80);
  const std::size_t sof = frame_marker(good);
  EXPECT_EQ(refusal(good), "accepted");
  EXPECT_THAT(refusal(with_byte(good, sof, 0xC2)), testing::HasSubstr("progressive"));
  EXPECT_THAT(refusal(with_byte(good, sof, 0xC3)), testing::HasSubstr("lossless"));
  EXPECT_THAT(refusal(with_byte(good, sof, 0xC5)), testing::HasSubstr("hierarchical"));
  EXPECT_THAT(refusal(with_byte(good, sof, 0xC9)), testing::HasSubstr("arithmetic"));
  EXPECT_THAT(refusal(with_byte(good, sof + 3, 12)), testing::HasSubstr("12 bits"));
  EXPECT_THAT(refusal(with_byte(good, sof + 8, 4)), testing::HasSubstr("CMYK"));
  EXPECT_THAT(refusal(with_byte(good, sof + 8, 2)), testing::HasSubstr("2 components"));
  EXPECT_THAT(refusal(with_byte(good, sof + 10, 0x41)), testing::HasSubstr("subsampling"));
  EXPECT_THAT(refusal(with_byte(good, sof + 4, 0xFF)), testing::HasSubstr("65296"));
  EXPECT_THAT(refusal(with_byte(with_byte(good, sof + 4, 0), sof + 5, 0)),
              testing::HasSubstr("16x0"));
  EXPECT_THAT(refusal({}), testing::HasSubstr("not a JPEG"));
}

TEST(Jpeg, SidesEndAtTheirLimit) {
  const Bytes good = encode_jpeg(gradient(16, 16), 80);
  const auto of_size = [&](int width, int height) {
    return refusal(with_size(good, width, height));
  };
  EXPECT_EQ(of_size(kMaxJpegSide, kMaxJpegSide), "accepted");
  EXPECT_THAT(of_size(kMaxJpegSide + 1, 1), testing::HasSubstr("2049x1"));
  EXPECT_THAT(of_size(1, kMaxJpegSide + 1), testing::HasSubstr("1x2049"));
}

TEST(Jpeg, RefusesMoreScansThanComponents) {
  EXPECT_THAT(refusal(with_more_scans(encode_jpeg(gradient(16, 16), 80), 1000)),
              testing::HasSubstr("more scans"));
}

// As many as there are components, and not one more.
TEST(Jpeg, AcceptsAsManyScansAsComponents) {
  const Bytes color = encode_jpeg(gradient(16, 16), 80);
  EXPECT_EQ(refusal(with_more_scans(color, 2)), "accepted");
  EXPECT_THAT(refusal(with_more_scans(color, 3)), testing::HasSubstr("more scans"));
  // Grey: one component in the frame header, and what it says of the other two is gone.
  const std::size_t sof = frame_marker(color);
  Bytes grey = with_byte(with_byte(color, sof + 2, 8 + 3), sof + 8, 1);
  grey.erase(grey.begin() + static_cast<std::ptrdiff_t>(sof) + 12,
             grey.begin() + static_cast<std::ptrdiff_t>(sof) + 18);
  EXPECT_EQ(refusal(with_more_scans(grey, 0)), "accepted");
  EXPECT_THAT(refusal(with_more_scans(grey, 1)), testing::HasSubstr("more scans"));
}

TEST(Jpeg, RefusesEveryTruncation) {
  const Bytes jpeg = encode_jpeg(gradient(64, 64), 80);
  for (std::size_t size = 0; size < jpeg.size(); ++size) {
    EXPECT_THROW(decode_jpeg(std::span(jpeg).first(size)), JpegError) << size;
  }
}

Bytes with_stray_bytes(Bytes jpeg, std::size_t at, std::size_t count) {
  jpeg.insert(jpeg.begin() + static_cast<std::ptrdiff_t>(at), count, std::byte{0x11});
  return jpeg;
}

// Many webcams do it, and everybody shows the picture: the data are whole.
TEST(Jpeg, StrayBytesBeforeAMarkerAreSkipped) {
  const Bytes jpeg = encode_jpeg(gradient(40, 30), 90);
  const common::ImageRgb8 expected = decode_jpeg(jpeg);
  const std::size_t frame = frame_marker(jpeg) - 1, end = jpeg.size() - 2;
  for (const std::size_t count : {1u, 2u, 6u, 64u}) {
    EXPECT_EQ(decode_jpeg(with_stray_bytes(jpeg, end, count)), expected) << count;
    EXPECT_EQ(decode_jpeg(with_stray_bytes(jpeg, frame, count)), expected) << count;
    EXPECT_TRUE(JpegCoefficients::read(with_stray_bytes(jpeg, end, count))) << count;
  }
  // So many are data that were not understood.
  EXPECT_THROW(decode_jpeg(with_stray_bytes(jpeg, end, 200)), JpegError);
}

TEST(Jpeg, AReportedWebcamFrameIsDecoded) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  const Bytes frame = read_file(*data / "reports/jpeg-extraneous-bytes/extran.jpg");
  Bytes clean = frame;
  clean.erase(clean.end() - 3);  // the stray byte stands before the end marker
  EXPECT_EQ(decode_jpeg(frame), decode_jpeg(clean));
  EXPECT_TRUE(JpegCoefficients::read(frame));
}

// What lies in memory from an earlier picture must never show in a damaged one (reliability, fault
// 15).
TEST(Jpeg, DamagedPicturesNeverShowEarlierPixels) {
  const Bytes magenta = encode_jpeg(common::ImageRgb8(64, 64, common::Rgb8(255, 0, 255)), 90);
  const Bytes green = encode_jpeg(common::ImageRgb8(64, 64, common::Rgb8(0, 200, 0)), 90);
  // As it is decoded: JPEG does not keep it to the last bit.
  const common::Rgb8 earlier = decode_jpeg(magenta).at(0, 0);
  std::mt19937 random(1);
  std::uniform_int_distribution<std::size_t> any_bit(0, green.size() * 8 - 1);
  for (int i = 0; i < 2000; ++i) {
    decode_jpeg(magenta);
    Bytes flipped = green;
    const std::size_t bit = any_bit(random);
    flipped[bit / 8] ^= std::byte{1} << (bit % 8);
    try {
      const common::ImageRgb8 image = decode_jpeg(flipped);
      // A flip may change colors but cannot make the previous picture.
      EXPECT_NE(image.at(0, 0), earlier);
    } catch (const JpegError&) {
    }
  }
}

TEST(Jpeg, EncoderRefusesWhatItCannotDo) {
  EXPECT_THROW(encode_jpeg(common::ImageRgb8(), 80), JpegError);
  EXPECT_THROW(encode_jpeg(gradient(4, 4), 0), JpegError);
  EXPECT_THROW(encode_jpeg(gradient(4, 4), 101), JpegError);
}

TEST(Jpeg, FuzzedFilesAreDecodedOrRefused) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  int decoded = 0, refused = 0;
  for (const Bytes& file : files_in(*data / "robustness" / "jpeg_afl_turbo")) {
    try {
      decode_jpeg(file);
      ++decoded;
    } catch (const JpegError& error) {
      EXPECT_STRNE(error.what(), "");
      ++refused;
    }
  }
  RecordProperty("decoded", decoded);
  RecordProperty("refused", refused);
  EXPECT_GT(decoded + refused, 900);
}

TEST(Jpeg, ARealPhotographIsAccepted) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  const auto path = *data / "real_markers" / "opencv_contrib" / "singlemarkersoriginal.jpg";
  EXPECT_EQ(decode_jpeg(read_file(path)).size(), glm::ivec2(640, 480));
}

TEST(Jpeg, ArithmeticAndTwelveBitFilesAreRefusedByName) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  std::vector<std::string> reasons;
  for (const Bytes& file : files_in(*data / "robustness" / "jpeg_valid"))
    reasons.push_back(refusal(file));
  EXPECT_THAT(reasons, testing::Contains(testing::HasSubstr("arithmetic")));
  EXPECT_THAT(reasons, testing::Contains(testing::HasSubstr("12 bits")));
  EXPECT_THAT(reasons, testing::Contains("accepted"));
}

}  // namespace
}  // namespace amalgam::codec
