#include "scene/light/tone_map.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace amalgam::scene {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// numerics B17.
TEST(ToneMap, CompressKeepsDigitsAtBothEnds) {
  EXPECT_EQ(compress(0.0f), 0.0f);
  EXPECT_FLOAT_EQ(compress(2e-38f), 2e-38f);
  EXPECT_FLOAT_EQ(compress(1e-8f), 1e-8f);
  EXPECT_EQ(compress(1.0f), 0.5f);
  EXPECT_NEAR(compress(65504.0f), 0.999985f, 1e-6f);
  EXPECT_EQ(compress(3e38f), 1.0f);
  EXPECT_EQ(compress(kInfinity), 1.0f);
}

TEST(ToneMap, CompressIsMonotone) {
  float before = 0.0f;
  for (float x = 1e-38f; x < 1e38f; x *= 1.01f) {
    EXPECT_GE(compress(x), before) << x;
    before = compress(x);
  }
}

TEST(ToneMap, ExpandIsTheInverse) {
  for (float d = 0.0f; d < 0.995f; d += 0.001f) EXPECT_NEAR(compress(expand(d)), d, 1e-6f) << d;
}

TEST(ToneMap, ExpandStaysFinite) {
  for (const float d : {1.0f, 2.0f, kInfinity}) {
    EXPECT_TRUE(std::isfinite(expand(d)));
    EXPECT_NEAR(expand(d), expand(srgb_decode(254.5f / 255.0f)), 0.01f);
  }
  EXPECT_EQ(expand(-1.0f), 0.0f);
}

TEST(ToneMap, ACameraPixelComesBackThroughTheTracer) {
  for (const ToneCurve curve : kToneCurves) {
    for (const float exposure : {0.1f, 1.0f, 7.0f}) {
      const ToneMap camera{{exposure, 2.0f * exposure, 0.5f * exposure}, curve};
      for (int byte = 0; byte < 255; ++byte) {
        const glm::vec3 seen(srgb_decode(static_cast<std::uint8_t>(byte)));
        EXPECT_EQ(srgb_encode(tone_map(inverse_tone_map(seen, camera), camera)),
                  common::Rgb8(static_cast<std::uint8_t>(byte)))
            << byte << " at " << exposure;
      }
    }
  }
}

TEST(ToneMap, LinearClips) {
  const ToneMap camera = tone_map_of(2.0f, ToneCurve::Linear);
  EXPECT_EQ(tone_map({0.0f, 0.25f, 0.75f}, camera), glm::vec3(0.0f, 0.5f, 1.0f));
  EXPECT_EQ(inverse_tone_map({0.0f, 0.5f, 1.0f}, camera), glm::vec3(0.0f, 0.25f, 0.5f));
}

TEST(ToneMap, AStepIsTheDifferenceOfItsEnds) {
  for (const ToneCurve curve : kToneCurves) {
    const ToneMap camera = tone_map_of(1.5f, curve);
    for (const float a : {0.0f, 0.1f, 0.5f, 3.0f}) {
      for (const float b : {0.5f, 0.7f, 40.0f}) {
        if (a > b) continue;
        const glm::vec3 expected = tone_map(glm::vec3(b), camera) - tone_map(glm::vec3(a), camera);
        EXPECT_NEAR(tone_map_step(glm::vec3(a), glm::vec3(b), camera).x, expected.x, 1e-6f);
      }
    }
  }
}

TEST(ToneMap, BytesSurviveDecodeAndEncode) {
  for (int byte = 0; byte < 256; ++byte) {
    EXPECT_EQ(srgb_encode(srgb_decode(static_cast<std::uint8_t>(byte))), byte);
  }
}

TEST(ToneMap, SrgbMatchesTheStandard) {
  EXPECT_EQ(srgb_decode(std::uint8_t{255}), 1.0f);
  EXPECT_NEAR(srgb_decode(std::uint8_t{188}), 0.502886f, 1e-6f);
  EXPECT_NEAR(srgb_decode(std::uint8_t{10}), 10.0f / 255.0f / 12.92f, 1e-7f);
  EXPECT_EQ(srgb_encode(0.5f), 188);
}

TEST(ToneMap, EncodeClampsAndNanIsBlack) {
  EXPECT_EQ(srgb_encode(-1.0f), 0);
  EXPECT_EQ(srgb_encode(2.0f), 255);
  EXPECT_EQ(srgb_encode(kInfinity), 255);
  EXPECT_EQ(srgb_encode(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(ToneMap, EncodeRoundsToNearest) {
  for (int byte = 0; byte < 255; ++byte) {
    const float middle = srgb_decode((static_cast<float>(byte) + 0.5f) / 255.0f);
    EXPECT_EQ(srgb_encode(middle * (1.0f - 1e-5f)), byte);
    EXPECT_EQ(srgb_encode(middle * (1.0f + 1e-5f)), byte + 1);
  }
}

// Where each byte begins: the value whose exact encoding is half-way from the byte before.
std::vector<float> beginnings() {
  std::vector<float> values;
  for (int byte = 1; byte < 256; ++byte) {
    const double encoded = (byte - 0.5) / 255.0;
    values.push_back(static_cast<float>(
        encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4)));
  }
  return values;
}

TEST(ToneMap, EncodeIsExactBesideEveryThreshold) {
  const std::vector<float> begins = beginnings();
  for (int byte = 1; byte < 256; ++byte) {
    const float begin = begins[static_cast<std::size_t>(byte) - 1];
    EXPECT_EQ(srgb_encode(std::nextafter(begin, 0.0f)), byte - 1) << byte;
    EXPECT_EQ(srgb_encode(begin), byte);
    EXPECT_EQ(srgb_encode(std::nextafter(begin, 1.0f)), byte);
  }
}

// Every 37th float from 0 to beyond 1, denormal ones included: 29 million.
TEST(ToneMap, EncodeIsExactEverywhere) {
  const std::vector<float> begins = beginnings();
  std::size_t byte = 0;
  const auto last = std::bit_cast<std::uint32_t>(1.5f);
  for (std::uint32_t bits = 0; bits < last; bits += 37) {
    const auto x = std::bit_cast<float>(bits);
    while (byte < begins.size() && x >= begins[byte]) ++byte;
    ASSERT_EQ(srgb_encode(x), byte) << x;
  }
}

}  // namespace
}  // namespace amalgam::scene
