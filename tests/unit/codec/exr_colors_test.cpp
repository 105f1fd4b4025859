#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfEnvmap.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "codec/color_space.h"
#include "codec/exr.h"
#include "support/test_data.h"

// Which channels of a file are its colors, and what its header says about them.

namespace amalgam::codec {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::ThrowsMessage;

class ExrColors : public testing::Test {
 protected:
  // Tests run side by side, each in a process of its own.
  const std::filesystem::path path_ = std::filesystem::path(testing::TempDir()) /
                                      ("exr_colors_" + std::to_string(getpid()) + ".exr");
  ~ExrColors() override { std::filesystem::remove(path_); }

  // Writes the image with these channel names for R, G and B.
  void write(Imf::Header header, const common::ImageRgb32f& image,
             const std::array<std::string, 3>& names) {
    Imf::FrameBuffer frame_buffer;
    for (std::size_t i = 0; i < 3; ++i) {
      header.channels().insert(names[i], Imf::Channel(Imf::FLOAT));
      char* base = reinterpret_cast<char*>(const_cast<glm::vec3*>(image.data())) + 4 * i;
      frame_buffer.insert(
          names[i], Imf::Slice(Imf::FLOAT, base, 12, 12 * static_cast<std::size_t>(image.width())));
    }
    Imf::OutputFile file(path_.c_str(), header);
    file.setFrameBuffer(frame_buffer);
    file.writePixels(image.height());
  }
  void write(const Imf::Header& header, const common::ImageRgb32f& image) {
    write(header, image, {"R", "G", "B"});
  }
};

common::Image32f plane(float value) {
  return common::Image32f(2, 1, value);
}

TEST_F(ExrColors, TheOnlyLayerIsRead) {
  for (const std::string layer : {"ViewLayer.Combined", "Layer 1", "left"}) {
    write_exr(path_, {{layer + ".R", plane(1)},
                      {layer + ".G", plane(2)},
                      {layer + ".B", plane(3)},
                      {layer + ".A", plane(9)},
                      {"ViewLayer.Depth.Z", plane(9)}});
    std::vector<std::string> notes;
    EXPECT_EQ(read_exr(path_, &notes).at(0, 0), glm::vec3(1, 2, 3));
    EXPECT_THAT(notes, Contains(HasSubstr("its layer " + layer + " is read")));
  }
}

TEST_F(ExrColors, PlainChannelsAndCombinedComeBeforeOtherLayers) {
  std::vector<std::pair<std::string, common::Image32f>> channels;
  for (const std::string layer : {"ViewLayer.Combined", "ViewLayer.DiffCol"}) {
    const float value = layer.ends_with("Combined") ? 1.0f : 7.0f;
    for (const char* c : {".R", ".G", ".B"}) channels.emplace_back(layer + c, plane(value));
  }
  write_exr(path_, channels);
  EXPECT_EQ(read_exr(path_).at(0, 0), glm::vec3(1.0f));
  channels.emplace_back("R", plane(5));
  write_exr(path_, channels);
  EXPECT_EQ(read_exr(path_).at(0, 0), glm::vec3(5, 0, 0));
}

TEST_F(ExrColors, AChoiceOfLayersIsRefusedByName) {
  std::vector<std::pair<std::string, common::Image32f>> channels;
  for (const std::string layer : {"one", "two"}) {
    for (const char* c : {".R", ".G", ".B"}) channels.emplace_back(layer + c, plane(1));
  }
  write_exr(path_, channels);
  EXPECT_THAT([&] { read_exr(path_); }, ThrowsMessage<ExrError>(HasSubstr("one, two")));
  write_exr(path_, {{"depth", plane(1)}, {"mask", plane(1)}});
  EXPECT_THAT([&] { read_exr(path_); }, ThrowsMessage<ExrError>(HasSubstr("but depth, mask")));
}

TEST_F(ExrColors, LuminanceAndChromaAreReadAsGreyWithANote) {
  const std::vector<Imf::Rgba> pixels(4, Imf::Rgba(0.5f, 0.25f, 1.0f));
  {
    Imf::RgbaOutputFile file(path_.c_str(), 2, 2, Imf::WRITE_YC);
    file.setFrameBuffer(pixels.data(), 1, 2);
    file.writePixels(2);
  }
  std::vector<std::string> notes;
  const glm::vec3 grey = read_exr(path_, &notes).at(0, 0);
  EXPECT_NEAR(grey.x, 0.2126f * 0.5f + 0.7152f * 0.25f + 0.0722f, 1e-2f);
  EXPECT_EQ(grey, glm::vec3(grey.x));
  EXPECT_THAT(notes, Contains(HasSubstr("its colors (RY, BY) are not supported; read as grey")));
}

// Blue alone is a color: its primary is not Rec. 709's.
TEST_F(ExrColors, ChromaticitiesOfOneChannelAreConverted) {
  Imf::Header header(1, 1);
  Imf::addChromaticities(header, Imf::Chromaticities({1, 0}, {0, 1}, {0, 0}, {1 / 3.0f, 1 / 3.0f}));
  write(header, common::ImageRgb32f(1, 1, glm::vec3(1.0f)), {"B", "other", "another"});
  std::vector<std::string> notes;
  const glm::vec3 color = read_exr(path_, &notes).at(0, 0);
  EXPECT_THAT(notes, Contains(HasSubstr("converted from its chromaticities")));
  EXPECT_LT(color.x, 0.0f);  // Z alone: less red than none
}

// ACES (AP0) and XYZ, stated. A grey of Rec. 709 in them, and back.
TEST_F(ExrColors, ChromaticitiesAreConverted) {
  const glm::vec3 color(0.2f, 0.5f, 0.9f);
  const Chromaticities aces{{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.077}, {0.32168, 0.33767}};
  const Chromaticities xyz{{1, 0}, {0, 1}, {0, 0}, {1.0 / 3.0, 1.0 / 3.0}};
  for (const Chromaticities& space : {aces, xyz}) {
    const glm::vec3 stored(glm::inverse(*rec709_from(space)) * glm::dvec3(color));
    Imf::Header header(1, 1);
    const auto v2f = [](const glm::dvec2& v) { return Imath::V2f(glm::vec2(v).x, glm::vec2(v).y); };
    Imf::addChromaticities(header, Imf::Chromaticities(v2f(space.red), v2f(space.green),
                                                       v2f(space.blue), v2f(space.white)));
    write(header, common::ImageRgb32f(1, 1, stored));
    std::vector<std::string> notes;
    EXPECT_LT(glm::distance(read_exr(path_, &notes).at(0, 0), color), 1e-5f);
    EXPECT_THAT(notes, Contains(HasSubstr("converted from its chromaticities")));
  }
}

TEST_F(ExrColors, ChromaticitiesOfRec709ChangeNothing) {
  Imf::Header header(1, 1);
  Imf::addChromaticities(header, Imf::Chromaticities());
  const common::ImageRgb32f image(1, 1, glm::vec3(0.1f, 0.7f, 3.0f));
  write(header, image);
  std::vector<std::string> notes;
  EXPECT_EQ(read_exr(path_, &notes), image);
  EXPECT_TRUE(notes.empty());
}

TEST_F(ExrColors, ChromaticitiesWithoutAColorSpaceAreRefused) {
  Imf::Header header(1, 1);
  const Imath::V2f same(0.3f, 0.3f);
  Imf::addChromaticities(header, Imf::Chromaticities(same, same, same, same));
  write(header, common::ImageRgb32f(1, 1));
  EXPECT_THAT([&] { read_exr(path_); }, ThrowsMessage<ExrError>(HasSubstr("no color space")));
}

// IEC 61966-2-1 and SMPTE ST 2065-1: matrices as they are printed there.
TEST(ColorSpace, MatricesAreThoseOfTheStandards) {
  const glm::dmat3 m = *xyz_from_rgb(Chromaticities{});
  EXPECT_NEAR(m[0][0], 0.4124, 1e-4);
  EXPECT_NEAR(m[1][0], 0.3576, 1e-4);
  EXPECT_NEAR(m[2][1], 0.0722, 1e-4);
  EXPECT_NEAR(m[2][2], 0.9505, 1e-4);
  const glm::dmat3 aces =
      *xyz_from_rgb({{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.077}, {0.32168, 0.33767}});
  EXPECT_NEAR(aces[0][0], 0.9525523959, 1e-9);
  EXPECT_NEAR(aces[0][1], 0.3439664498, 1e-9);
  EXPECT_NEAR(aces[2][2], 1.0088251844, 1e-9);
  EXPECT_FALSE(xyz_from_rgb({{0.3, 0.3}, {0.3, 0.3}, {0.3, 0.3}, {0.3, 0.3}}));
}

// Every texel of a face holds its own direction, which is linear across the face after division by
// its largest component.
TEST_F(ExrColors, CubeMapsBecomeLatitudeLongitude) {
  constexpr int kSide = 16;
  Imf::Header header(kSide, 6 * kSide);
  Imf::addEnvmap(header, Imf::ENVMAP_CUBE);
  common::ImageRgb32f cube(kSide, 6 * kSide);
  const Imath::Box2i window = header.dataWindow();
  for (int f = 0; f < 6; ++f) {
    const auto face = static_cast<Imf::CubeMapFace>(f);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const Imath::V2f in_face(static_cast<float>(x), static_cast<float>(y));
        Imath::V3f d = Imf::CubeMap::direction(face, window, in_face);
        d /= std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        const Imath::V2f at = Imf::CubeMap::pixelPosition(face, window, in_face);
        cube.at(static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y))) = {
            d.x, d.y, d.z};
      }
    }
  }
  write(header, cube);
  std::vector<std::string> notes;
  const common::ImageRgb32f map = read_exr(path_, &notes);
  EXPECT_THAT(notes, Contains(HasSubstr("from a cube map")));
  ASSERT_EQ(map.size(), glm::ivec2(4 * kSide, 2 * kSide));
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const double pi = std::numbers::pi;
      const double longitude = 2 * pi * (0.5 - (x + 0.5) / map.width());
      const double colatitude = pi * (y + 0.5) / map.height();
      const glm::dvec3 direction(std::sin(colatitude) * std::sin(longitude), std::cos(colatitude),
                                 std::sin(colatitude) * std::cos(longitude));
      EXPECT_LT(glm::distance(glm::normalize(glm::dvec3(map.at(x, y))), direction), 1e-5)
          << x << " " << y;
    }
  }
}

TEST_F(ExrColors, ReportedFiles) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  const auto plain = read_exr(*data / "reports/exr-chromaticities/plain.exr");
  const auto xyz = read_exr(*data / "reports/exr-chromaticities/xyz.exr");
  const auto layer = read_exr(*data / "reports/exr-multilayer/multilayer.exr");
  EXPECT_EQ(layer, plain);
  ASSERT_EQ(xyz.size(), plain.size());
  for (std::size_t i = 0; i < plain.pixels().size(); ++i) {
    // Halves have 11 bits, and XYZ to Rec. 709 magnifies their rounding by 3.24 + 1.54 + 0.5.
    const float largest = std::max({plain.pixels()[i].x, plain.pixels()[i].y, plain.pixels()[i].z});
    EXPECT_LT(glm::distance(xyz.pixels()[i], plain.pixels()[i]), 0.01f * largest + 1e-6f) << i;
  }
}

}  // namespace
}  // namespace amalgam::codec
