// What files patching refuses, declines or keeps parts of.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "codec/jpeg_patch.h"
#include "jpeg_samples.h"
#include "support/test_data.h"

namespace amalgam::codec {
namespace {

using namespace std::string_view_literals;
using tests::Bytes;
using tests::noisy_picture;
using tests::SampleColor;
using tests::SampleKind;

Bytes sample(const SampleKind& kind) {
  return sample_jpeg(noisy_picture(40, 40, 1, kind.color == SampleColor::Grey), kind);
}

bool patchable(const Bytes& jpeg) {
  return JpegCoefficients::read(jpeg).has_value();
}

bool holds(const Bytes& bytes, std::string_view text) {
  const auto* first = reinterpret_cast<const char*>(bytes.data());
  return std::string_view(first, bytes.size()).find(text) != std::string_view::npos;
}

// The index of the first byte after a marker's code.
std::size_t after_marker(const Bytes& jpeg, int code) {
  const Bytes marker{std::byte{0xFF}, static_cast<std::byte>(code)};
  const auto found = std::search(jpeg.begin(), jpeg.end(), marker.begin(), marker.end());
  return static_cast<std::size_t>(found - jpeg.begin()) + 2;
}

std::optional<Bytes> patched(const Bytes& camera, const common::ImageRgb8& composite) {
  auto coefficients = JpegCoefficients::read(camera);
  if (!coefficients) return std::nullopt;
  const auto across = static_cast<std::size_t>((composite.width() + kPatchTile - 1) / kPatchTile);
  const auto down = static_cast<std::size_t>((composite.height() + kPatchTile - 1) / kPatchTile);
  std::vector<std::uint8_t> flags(across * down);
  for (std::size_t i = 0; i < flags.size(); i += 2) flags[i] = 1;
  return patch_jpeg(*std::move(coefficients), composite, flags);
}

TEST(JpegPatchFiles, OtherColorsThanYCbCrAreDeclined) {
  EXPECT_TRUE(patchable(sample({})));
  const SampleKind rgb{.color = SampleColor::Rgb, .luma = {1, 1}};
  EXPECT_NO_THROW(decode_jpeg(sample(rgb)));
  EXPECT_FALSE(patchable(sample(rgb)));
  // Without any marker the names R, G, B say so.
  const SampleKind named{.luma = {1, 1}, .ids = {'R', 'G', 'B'}, .jfif = false};
  EXPECT_FALSE(patchable(sample(named)));
}

TEST(JpegPatchFiles, ColorOnGreyIsDeclined) {
  const Bytes grey = sample({.color = SampleColor::Grey, .luma = {1, 1}});
  EXPECT_TRUE(patched(grey, noisy_picture(40, 40, 2, true)));
  common::ImageRgb8 composite = noisy_picture(40, 40, 2, true);
  composite.at(20, 5).y ^= 1;  // in a tile that is not touched
  EXPECT_TRUE(patched(grey, composite));
  composite.at(39, 15).z ^= 1;  // in one that is
  EXPECT_FALSE(patched(grey, composite));
}

TEST(JpegPatchFiles, MoreThanTenBlocksInAnMcuAreDeclined) {
  const SampleKind kind{.luma = {2, 2}, .chroma = {2, 2}, .scan_for_each_component = true};
  EXPECT_EQ(read_jpeg_header(sample(kind)).subsampling, JpegSubsampling::Yuv444);
  EXPECT_FALSE(patchable(sample(kind)));
}

TEST(JpegPatchFiles, ImpossibleCoefficientsAreDeclined) {
  EXPECT_TRUE(patchable(sample({.bright_dc = 1023})));
  EXPECT_TRUE(patchable(sample({.bright_dc = -1024})));
  EXPECT_NO_THROW(decode_jpeg(sample({.bright_dc = 2000})));
  EXPECT_FALSE(patchable(sample({.bright_dc = 1024})));
  EXPECT_FALSE(patchable(sample({.bright_dc = -1025})));
}

// One grey block with the quantisation table, Huffman tables and bits of our choice: its first AC
// coefficient is 2047, of one bit more than the standard tables have codes for.
TEST(JpegPatchFiles, ImpossibleAcCoefficientsAreDeclined) {
  std::vector<int> values{0xFF, 0xD8, 0xFF, 0xDB, 0, 67, 0};
  values.insert(values.end(), 64, 1);  // quantisation
  values.insert(values.end(), {0xFF, 0xC0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0});
  values.insert(values.end(), {0xFF, 0xC4, 0, 20, 0x00, 1});  // DC: one code of one bit
  values.insert(values.end(), 15, 0);
  values.insert(values.end(), {0});                              // it says "no difference"
  values.insert(values.end(), {0xFF, 0xC4, 0, 21, 0x10, 1, 1});  // AC: codes of one and two bits
  values.insert(values.end(), 14, 0);
  values.insert(values.end(), {0x0B, 0});  // "11 bits follow" and "end of block"
  values.insert(values.end(), {0xFF, 0xDA, 0, 8, 1, 1, 0, 0, 63, 0, 0x3F, 0xFD, 0xFF, 0xD9});
  Bytes jpeg;
  for (const int value : values) jpeg.push_back(static_cast<std::byte>(value));
  EXPECT_NO_THROW(decode_jpeg(jpeg));
  EXPECT_EQ(tests::blocks_of(jpeg)[0].blocks[0][1], 2047);
  EXPECT_FALSE(patchable(jpeg));
}

// Dividing by such a step would end the program.
TEST(JpegPatchFiles, AQuantisationStepOfZeroIsDeclined) {
  Bytes jpeg = sample({});
  jpeg[after_marker(jpeg, 0xDB) + 10] = std::byte{0};
  EXPECT_NO_THROW(decode_jpeg(jpeg));
  EXPECT_FALSE(patchable(jpeg));
}

TEST(JpegPatchFiles, AMissingQuantisationTableIsNoWayToCrash) {
  Bytes jpeg = sample({});
  const std::size_t frame = after_marker(jpeg, 0xC0);
  jpeg[frame + 10] = std::byte{3};  // luma's table: only 0 and 1 are there
  EXPECT_THROW(patchable(jpeg), JpegError);
  jpeg[frame + 10] = std::byte{200};
  EXPECT_THROW(patchable(jpeg), JpegError);
}

// A table may be sent again between scans with another content; the file is legal.
TEST(JpegPatchFiles, ATableWithTwoContentsIsDeclined) {
  Bytes jpeg = sample({.scan_for_each_component = true});
  const std::size_t first = after_marker(jpeg, 0xDA);
  const auto begin = jpeg.begin() + static_cast<std::ptrdiff_t>(first);
  const Bytes marker{std::byte{0xFF}, std::byte{0xDA}};
  Bytes table{std::byte{0xFF}, std::byte{0xDB}, std::byte{0}, std::byte{67}, std::byte{0}};
  table.resize(69, std::byte{9});
  jpeg.insert(std::search(begin, jpeg.end(), marker.begin(), marker.end()), table.begin(),
              table.end());
  EXPECT_NO_THROW(decode_jpeg(jpeg));
  EXPECT_FALSE(patchable(jpeg));
}

TEST(JpegPatchFiles, MetadataAreKept) {
  const auto profile = "ICC_PROFILE\0\1\1what red is"sv, exif = "Exif\0\0which way is up"sv;
  const Bytes camera = tests::with_segment(tests::with_segment(sample({}), 2, profile), 1, exif);
  const auto out = patched(camera, noisy_picture(40, 40, 2));
  ASSERT_TRUE(out);
  EXPECT_TRUE(holds(*out, profile));
  EXPECT_TRUE(holds(*out, "JFIF"sv));
  EXPECT_TRUE(holds(*out, exif));
  EXPECT_NO_THROW(decode_jpeg(*out));
}

TEST(JpegPatchFiles, EveryTruncationIsRefused) {
  const Bytes jpeg = sample({});
  for (std::size_t size = 0; size < jpeg.size(); ++size) {
    EXPECT_THROW(JpegCoefficients::read(std::span(jpeg).first(size)), JpegError) << size;
  }
}

TEST(JpegPatchFiles, AnotherSizeIsOurOwnMistake) {
  EXPECT_DEATH(patched(sample({}), noisy_picture(40, 41, 2)), "40x40");
}

// What decodes is patched or declined; what does not is refused. Whatever is patched decodes.
TEST(JpegPatchFiles, HostileFiles) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  int count = 0, patched_files = 0;
  for (const char* folder : {"jpeg_afl_turbo", "jpeg_valid"}) {
    for (const auto& entry : std::filesystem::directory_iterator(*data / "robustness" / folder)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream file(entry.path(), std::ios::binary);
      const std::string text((std::istreambuf_iterator<char>(file)), {});
      const auto* begin = reinterpret_cast<const std::byte*>(text.data());
      const Bytes bytes(begin, begin + text.size());
      ++count;
      std::optional<common::ImageRgb8> decoded;
      try {
        decoded = decode_jpeg(bytes);
      } catch (const JpegError&) {
      }
      if (!decoded) {
        EXPECT_THROW(JpegCoefficients::read(bytes), JpegError) << entry.path();
        continue;
      }
      const auto out = patched(bytes, *decoded);
      if (!out) continue;
      ++patched_files;
      EXPECT_EQ(decode_jpeg(*out).size(), decoded->size()) << entry.path();
    }
  }
  RecordProperty("patched", patched_files);
  EXPECT_GT(count, 900);
  EXPECT_GE(patched_files, 1);
}

}  // namespace
}  // namespace amalgam::codec
