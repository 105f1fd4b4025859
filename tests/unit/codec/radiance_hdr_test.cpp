#include "codec/radiance_hdr.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>

#include "support/test_data.h"

namespace amalgam::codec {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

common::ImageRgb32f decode(const std::string& file) {
  return decode_radiance_hdr(std::as_bytes(std::span(file)));
}

std::string with_header(const std::string& lines, const std::string& size,
                        const std::string& pixels) {
  return "#?RADIANCE\n" + lines + "\n" + size + "\n" + pixels;
}

// Mantissa 128 with exponent 129 is 1.
std::string pixel(int r, int g, int b, int e) {
  return {static_cast<char>(r), static_cast<char>(g), static_cast<char>(b), static_cast<char>(e)};
}

// Two lines of 8 pixels, 4 of them (1, 0.5, 0.25) and 4 (2, 2, 2), in each of the three encodings.
std::string flat() {
  std::string line;
  for (int i = 0; i < 4; ++i) line += pixel(128, 64, 32, 129);
  for (int i = 0; i < 4; ++i) line += pixel(128, 128, 128, 130);
  return line + line;
}
std::string pixel_runs() {
  const std::string line =
      pixel(128, 64, 32, 129) + pixel(1, 1, 1, 3) + pixel(128, 128, 128, 130) + pixel(1, 1, 1, 3);
  return line + line;
}
std::string component_runs() {
  const auto runs = [](int a, int b) {
    return std::string{static_cast<char>(132), static_cast<char>(a), 4,
                       static_cast<char>(b),   static_cast<char>(b), static_cast<char>(b),
                       static_cast<char>(b)};
  };
  const std::string line =
      pixel(2, 2, 0, 8) + runs(128, 128) + runs(64, 128) + runs(32, 128) + runs(129, 130);
  return line + line;
}

TEST(RadianceHdr, ThreeEncodingsOfOnePicture) {
  common::ImageRgb32f expected(8, 2, glm::vec3(1.0f, 0.5f, 0.25f));
  for (int y = 0; y < 2; ++y) {
    for (int x = 4; x < 8; ++x) expected.at(x, y) = glm::vec3(2.0f);
  }
  for (const std::string& pixels : {flat(), pixel_runs(), component_runs()}) {
    EXPECT_EQ(decode(with_header("FORMAT=32-bit_rle_rgbe\n", "-Y 2 +X 8", pixels)), expected);
  }
}

// 44 + 256 * 1 repeats.
TEST(RadianceHdr, OlderRunLengthsHaveDigits) {
  const auto image = decode(with_header("", "-Y 1 +X 302",
                                        pixel(128, 128, 128, 129) + pixel(1, 1, 1, 44) +
                                            pixel(1, 1, 1, 1) + pixel(128, 128, 128, 131)));
  EXPECT_EQ(image.at(300, 0), glm::vec3(1.0f));
  EXPECT_EQ(image.at(301, 0), glm::vec3(4.0f));
}

TEST(RadianceHdr, ExposureAndColorCorrectionAreDividedOut) {
  const std::string one = pixel(128, 128, 128, 129);
  EXPECT_EQ(decode(with_header("EXPOSURE=4.0\n", "-Y 1 +X 1", one)).at(0, 0), glm::vec3(0.25f));
  EXPECT_EQ(decode(with_header("EXPOSURE= 2\nEXPOSURE=+4e0\r\n", "-Y 1 +X 1", one)).at(0, 0),
            glm::vec3(0.125f));
  EXPECT_EQ(decode(with_header("COLORCORR=1 2 4\n", "-Y 1 +X 1", one)).at(0, 0),
            glm::vec3(1.0f, 0.5f, 0.25f));
  // A quoted header of a picture that this one was made from.
  EXPECT_EQ(decode(with_header("\tEXPOSURE=4\n", "-Y 1 +X 1", one)).at(0, 0), glm::vec3(1.0f));
}

// The D65 white point as XYZ is 0.95046 1 1.08906, here rounded to 1/128.
TEST(RadianceHdr, XyzAndPrimariesAreConverted) {
  const auto white =
      decode(with_header("FORMAT=32-bit_rle_xyze\n", "-Y 1 +X 1", pixel(122, 128, 139, 129)));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(white.at(0, 0)[i], 1.0f, 0.012f);
  // Primaries of XYZ itself: red is X. The first column of IEC 61966-2-1's matrix.
  const auto red = decode(with_header("PRIMARIES= 1 0 0 1 0 0 .33333333 .33333333\n", "-Y 1 +X 1",
                                      pixel(128, 0, 0, 129)));
  EXPECT_NEAR(red.at(0, 0).x, 3.2406, 2e-3);
  EXPECT_NEAR(red.at(0, 0).y, -0.9689, 2e-3);
  EXPECT_NEAR(red.at(0, 0).z, 0.0557, 2e-3);
}

TEST(RadianceHdr, EveryOrderOfPixels) {
  std::string pixels;
  for (int i = 0; i < 6; ++i) pixels += pixel(128, 128, 128, 129 + i);
  const auto corners = [&](const std::string& size) {
    const auto image = decode(with_header("", size, pixels));
    EXPECT_EQ(image.size(), glm::ivec2(3, 2)) << size;
    return std::array{image.at(0, 0).x, image.at(2, 0).x, image.at(0, 1).x, image.at(2, 1).x};
  };
  using Corners = std::array<float, 4>;
  EXPECT_EQ(corners("-Y 2 +X 3"), (Corners{1, 4, 8, 32}));
  EXPECT_EQ(corners("-Y 2 -X 3"), (Corners{4, 1, 32, 8}));
  EXPECT_EQ(corners("+Y 2 +X 3"), (Corners{8, 32, 1, 4}));
  EXPECT_EQ(corners("+Y 2 -X 3"), (Corners{32, 8, 4, 1}));
  EXPECT_EQ(corners("+X 3 -Y 2"), (Corners{1, 16, 2, 32}));
  EXPECT_EQ(corners("-X 3 -Y 2"), (Corners{16, 1, 32, 2}));
  EXPECT_EQ(corners("+X 3 +Y 2"), (Corners{2, 32, 1, 16}));
  EXPECT_EQ(corners("-X 3 +Y 2"), (Corners{32, 2, 16, 1}));
}

TEST(RadianceHdr, EveryTruncationIsRefused) {
  for (const std::string& pixels : {flat(), pixel_runs(), component_runs()}) {
    const std::string whole = with_header("", "-Y 2 +X 8", pixels);
    for (std::size_t size = 3; size < whole.size(); ++size) {
      EXPECT_THAT([&] { decode(whole.substr(0, size)); },
                  ThrowsMessage<PictureError>(HasSubstr("damaged picture")))
          << size;
    }
    EXPECT_NO_THROW(decode(whole));
  }
}

TEST(RadianceHdr, DamageIsNamed) {
  const auto refuses = [](const std::string& file, const std::string& why) {
    EXPECT_THAT([&] { decode(file); }, ThrowsMessage<PictureError>(HasSubstr(why)));
  };
  refuses("GIF89a", "not a Radiance picture");
  refuses(with_header("FORMAT=16-bit\n", "-Y 1 +X 1", ""), "FORMAT is '16-bit'");
  refuses(with_header("EXPOSURE=0\n", "-Y 1 +X 1", ""), "EXPOSURE is not positive");
  refuses(with_header("EXPOSURE=bright\n", "-Y 1 +X 1", ""), "EXPOSURE is not 1 number");
  refuses(with_header("", "-Y 1 -Y 1", ""), "no size");
  refuses(with_header("", "-Y 1 +X 99999999999999", ""), "no size");
  refuses(with_header("", "-Y 99999 +X 99999", ""), "outside the limits");
  refuses(with_header("", "-Y 1 +X 4", pixel(1, 1, 1, 3)), "begins with a run");
  refuses(with_header("", "-Y 1 +X 4", pixel(9, 9, 9, 9) + pixel(1, 1, 1, 4)), "longer than");
  refuses(with_header("", "-Y 1 +X 9", component_runs()), "another length");
}

// No input is read beyond its end, or for long: what costs time is a pixel or a byte.
TEST(RadianceHdr, RandomDamageIsReadOrRefused) {
  std::mt19937 random(7);
  int refused = 0;
  constexpr int kRounds = 20000;
  const std::array files{with_header("EXPOSURE=2\n", "-Y 2 +X 8", flat()),
                         with_header("", "-Y 2 +X 8", pixel_runs()),
                         with_header("", "+X 2 +Y 8", component_runs())};
  for (int round = 0; round < kRounds; ++round) {
    std::string file = files[static_cast<std::size_t>(round) % files.size()];
    const std::size_t changes = 1 + random() % 4;
    for (std::size_t k = 0; k < changes; ++k) {
      // The digits of the size stay: large pictures are legitimate and would only take time.
      const std::size_t first = random() % 4 == 0 ? 0 : file.rfind('\n', file.find('Y') + 8) + 1;
      const std::size_t at = first + random() % (file.size() - first);
      if (!std::isdigit(static_cast<unsigned char>(file[at]))) {
        file[at] = static_cast<char>(random());
      }
    }
    if (random() % 4 == 0) file.resize(random() % file.size());
    try {
      decode(file);
    } catch (const PictureError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, kRounds / 4);
  EXPECT_LT(refused, kRounds);
}

std::string report(const std::filesystem::path& name) {
  std::ifstream file(*tests::test_data() / "reports" / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(RadianceHdr, ReportedFiles) {
  if (!tests::test_data()) GTEST_SKIP() << "test data not found";
  EXPECT_THAT([] { decode(report("hdr-truncated-hang/trunc.hdr")); },
              ThrowsMessage<PictureError>("damaged picture: truncated"));
  EXPECT_EQ(decode(report("hdr-exposure/exposure.hdr")), decode(report("hdr-exposure/new.hdr")));
}

}  // namespace
}  // namespace amalgam::codec
