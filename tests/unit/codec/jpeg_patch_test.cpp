#include "codec/jpeg_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <future>
#include <random>
#include <string>

#include "jpeg_samples.h"

namespace amalgam::codec {
namespace {

using tests::Bytes;
using tests::ComponentBlocks;
using tests::noisy_picture;
using tests::SampleColor;
using tests::SampleKind;

using Flags = std::vector<std::uint8_t>;

int tiles_across(const common::ImageRgb8& image) {
  return (image.width() + kPatchTile - 1) / kPatchTile;
}

std::size_t tile_count(const common::ImageRgb8& image) {
  return static_cast<std::size_t>(tiles_across(image) *
                                  ((image.height() + kPatchTile - 1) / kPatchTile));
}

Flags random_flags(const common::ImageRgb8& image, double share) {
  std::mt19937 random(3);
  std::bernoulli_distribution touched(share);
  Flags flags(tile_count(image));
  for (auto& flag : flags) flag = touched(random);
  return flags;
}

Bytes patched(const Bytes& camera, const common::ImageRgb8& composite, const Flags& flags) {
  auto coefficients = JpegCoefficients::read(camera);
  if (!coefficients) return {};
  return patch_jpeg(*std::move(coefficients), composite, flags).value_or(Bytes{});
}

// Whether any pixel of [x0, x1) x [y0, y1) is in a flagged tile.
bool flagged(const common::ImageRgb8& image, const Flags& flags, int x0, int y0, int x1, int y1) {
  for (int y = std::max(y0, 0); y < std::min(y1, image.height()); ++y) {
    for (int x = std::max(x0, 0); x < std::min(x1, image.width()); ++x) {
      const int tile = y / kPatchTile * tiles_across(image) + x / kPatchTile;
      if (flags[static_cast<std::size_t>(tile)] != 0) return true;
    }
  }
  return false;
}

struct Case {
  std::string name;
  SampleKind kind;
  int mcu_width;   // pixels
  int mcu_height;  // pixels
};

void PrintTo(const Case& tested, std::ostream* out) {
  *out << tested.name;
}

std::vector<Case> cases() {
  const std::array<int, 2> one{1, 1}, wide{2, 1}, square{2, 2};
  return {
      {"Yuv420", {.luma = square}, 16, 16},
      {"Yuv422", {.luma = wide}, 16, 8},
      {"Yuv444", {.luma = one}, 8, 8},
      {"Grey", {.color = SampleColor::Grey, .luma = one}, 8, 8},
      {"GreyOfFourBlocks", {.color = SampleColor::Grey, .luma = square}, 16, 16},
      {"FourToTwo", {.luma = {4, 1}, .chroma = {2, 1}}, 32, 8},
      {"RestartMarkers", {.luma = square, .restart_interval = 3}, 16, 16},
      {"ThreeScans", {.luma = square, .scan_for_each_component = true}, 16, 16},
      {"ThreeScans422",
       {.luma = wide, .restart_interval = 2, .scan_for_each_component = true},
       16,
       8},
      {"OddNames", {.luma = square, .ids = {7, 0, 200}, .jfif = false}, 16, 16},
      {"SameNames", {.luma = square, .ids = {5, 5, 5}}, 16, 16},
      {"Coarse", {.luma = square, .quality = 5}, 16, 16},
      {"Finest", {.luma = square, .quality = 100}, 16, 16},
  };
}

class JpegPatch : public testing::TestWithParam<Case> {
 protected:
  common::ImageRgb8 picture(glm::ivec2 size, unsigned seed) const {
    return noisy_picture(size.x, size.y, seed, GetParam().kind.color == SampleColor::Grey);
  }
  Bytes camera(const common::ImageRgb8& image) const { return sample_jpeg(image, GetParam().kind); }
};

constexpr glm::ivec2 kSizes[]{{640, 320}, {376, 48}, {161, 77}, {17, 33}, {8, 100}, {1, 1}};

// Each block of the patched file is the camera's where nothing is touched, and elsewhere what it is
// if everything is touched: it does not depend on what else was encoded with it.
TEST_P(JpegPatch, BlocksAreTheCamerasOrTheCompositesBitForBit) {
  for (const glm::ivec2& size : kSizes) {
    const common::ImageRgb8 composite = picture(size, 2);
    const Bytes before = camera(picture(size, 1));
    const Flags flags = random_flags(composite, 0.3);
    const auto untouched = tests::blocks_of(before);
    const auto all = tests::blocks_of(patched(before, composite, Flags(flags.size(), 1)));
    const auto mixed = tests::blocks_of(patched(before, composite, flags));
    ASSERT_EQ(mixed.size(), untouched.size());
    for (std::size_t c = 0; c < mixed.size(); ++c) {
      ASSERT_EQ(mixed[c].blocks.size(), untouched[c].blocks.size());
      EXPECT_EQ(mixed[c].quantisation, untouched[c].quantisation);
      for (std::size_t i = 0; i < mixed[c].blocks.size(); ++i) {
        const int across = mixed[c].across;
        const int x = static_cast<int>(i) % across / mixed[c].per_mcu_x * GetParam().mcu_width;
        const int y = static_cast<int>(i) / across / mixed[c].per_mcu_y * GetParam().mcu_height;
        const bool touched =
            flagged(composite, flags, x, y, x + GetParam().mcu_width, y + GetParam().mcu_height);
        ASSERT_EQ(mixed[c].blocks[i], (touched ? all : untouched)[c].blocks[i])
            << "component " << c << ", MCU at " << x << ", " << y << " of " << size.x << "x"
            << size.y << (touched ? ", touched" : ", untouched");
      }
    }
  }
}

// 317 is odd: below an even height the invisible rest of chroma blocks may be filled in other ways.
TEST_P(JpegPatch, AllTouchedIsWhatLibjpegMakesOfTheWholeComposite) {
  for (const glm::ivec2& size : {glm::ivec2(640, 320), {631, 317}}) {
    const common::ImageRgb8 composite = picture(size, 2);
    const Bytes before = camera(picture(size, 1));
    const auto all = tests::blocks_of(patched(before, composite, Flags(tile_count(composite), 1)));
    const auto whole = tests::blocks_of(camera(composite));
    for (std::size_t c = 0; c < whole.size(); ++c) EXPECT_EQ(all[c].blocks, whole[c].blocks) << c;
  }
}

TEST_P(JpegPatch, UntouchedPixelsAreBitEqual) {
  const glm::ivec2 size(161, 77);
  const common::ImageRgb8 composite = picture(size, 2);
  const Bytes before = camera(picture(size, 1));
  const Flags flags = random_flags(composite, 0.1);
  const Bytes after = patched(before, composite, flags);
  const common::ImageRgb8 plain[]{tests::decode_unsmoothed(before),
                                  tests::decode_unsmoothed(after)};
  const common::ImageRgb8 smooth[]{decode_jpeg(before), decode_jpeg(after)};
  const int width = GetParam().mcu_width, height = GetParam().mcu_height;
  int compared = 0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const int left = x / width * width, top = y / height * height;
      if (flagged(composite, flags, left, top, left + width, top + height)) continue;
      ASSERT_EQ(plain[0].at(x, y), plain[1].at(x, y)) << x << ", " << y;
      // Smoothing reads chroma of neighbours.
      if (flagged(composite, flags, left - width, top - height, left + 2 * width, top + 2 * height))
        continue;
      ASSERT_EQ(smooth[0].at(x, y), smooth[1].at(x, y)) << x << ", " << y;
      ++compared;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST_P(JpegPatch, ShapeIsKept) {
  const common::ImageRgb8 image = picture({61, 43}, 1);
  const Bytes before = camera(image);
  const JpegHeader in = read_jpeg_header(before);
  const JpegHeader out = read_jpeg_header(patched(before, image, random_flags(image, 0.5)));
  EXPECT_EQ(out.width, in.width);
  EXPECT_EQ(out.height, in.height);
  EXPECT_EQ(out.subsampling, in.subsampling);
}

INSTANTIATE_TEST_SUITE_P(Kinds, JpegPatch, testing::ValuesIn(cases()),
                         [](const auto& tested) { return tested.param.name; });

TEST(JpegPatchHalves, CoefficientsCanBeReadOnAnotherThread) {
  const common::ImageRgb8 composite = noisy_picture(64, 64, 2);
  const Flags flags = random_flags(composite, 0.5);
  const Bytes camera = tests::sample_jpeg(noisy_picture(64, 64, 1), {});
  auto early = std::async(std::launch::async, [bytes = camera] {
    return JpegCoefficients::read(bytes);  // the bytes are gone when it is used
  });
  EXPECT_EQ(patch_jpeg(*early.get(), composite, flags), patched(camera, composite, flags));
}

}  // namespace
}  // namespace amalgam::codec
