// Plain shadow maps: wrong only within a few texels of edges of shadows, and by no more than light
// changes there.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>

#include "parity/everything_case.h"
#include "parity/materials_case.h"
#include "parity/rendering.h"
#include "parity/shadow_edges.h"
#include "support/compare_images.h"

namespace amalgam::parity {
namespace {

// How far from an edge a map may be wrong, in its texels: it samples casters at texels' centres
// (half a diagonal) and mixes four texels (one). Maps of glass have half as many texels a side.
constexpr double kBand = 0.71 + 1.0;
constexpr double kGlassBand = 2.0 * (0.71 + 1.0);

// The share of a map's error that may come from elsewhere: rounding, and circles that were missed.
constexpr double kSlack = 1.05;

constexpr int kLargestStep = 3;  // 1/255, between a composite and the reference's

struct BandCounts {
  std::size_t pixels = 0;
  std::size_t wrong = 0;  // off by more than 3/255; of those:
  std::size_t at_rim = 0, grazing = 0, in_band = 0;
  std::size_t elsewhere = 0;
  double farthest = 0.0;  // texels
  std::string where;      // of those elsewhere
  // For a failing test.
  common::Image<double> steps_elsewhere;  // 1/255
  common::ImageRgb8 composite;
};

// Without characters that a path should not have.
std::string file_name(const ParityCase& parity_case) {
  std::string name = parity_case.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '/' || c == ' '; }, '-');
  return name;
}

int largest_step(const common::Rgb8& a, const common::Rgb8& b) {
  const glm::ivec3 step = glm::abs(glm::ivec3(a) - glm::ivec3(b));
  return std::max({step.r, step.g, step.b});
}

// How far I_m and I_r are from what they should be, beyond what surrounding shadows explain.
double unexplained(const Rendering& actual, const reference::ReferenceImages& expected,
                   const ShadowEdges::Surroundings& around, int x, int y) {
  using reference::Color;
  const auto& mixed = std::get<common::ImageRgb32f>(actual.buffers.at("mixed"));
  const auto& real = std::get<common::ImageRgb32f>(actual.buffers.at("real"));
  Color error = glm::abs(Color(mixed.at(x, y)) - expected.mixed.at(x, y));
  if (expected.virtual_mask.at(x, y) == 0) {
    error = glm::max(error, glm::abs(Color(real.at(x, y)) - expected.real.at(x, y)));
  }
  return reference::largest_channel(error - kSlack * around.change);
}

BandCounts count_wrong_pixels(const ParityCase& parity_case, double band) {
  constexpr double kRounding = 1e-4;  // scene-linear
  frame::RendererSettings settings;
  settings.mode = frame::RendererMode::Hybrid;
  const Rendering actual = render(parity_case, settings);
  const reference::ReferenceImages& expected = reference_images(parity_case);
  const ShadowEdges edges(parity_case);
  BandCounts counts;
  counts.pixels = actual.composite.pixels().size();
  counts.composite = actual.composite;
  counts.steps_elsewhere =
      common::Image<double>(actual.composite.width(), actual.composite.height());
  for (int y = 0; y < actual.composite.height(); ++y) {
    for (int x = 0; x < actual.composite.width(); ++x) {
      const int step = largest_step(actual.composite.at(x, y), expected.composite.at(x, y));
      if (step <= kLargestStep) continue;
      ++counts.wrong;
      if (expected.rim.at(x, y) != 0) {
        ++counts.at_rim;
        continue;
      }
      if (expected.grazing.at(x, y) != 0) {
        ++counts.grazing;
        continue;
      }
      const ShadowEdges::Surroundings around = edges.around(x, y, band);
      if (around.distance <= band && unexplained(actual, expected, around, x, y) < kRounding) {
        ++counts.in_band;
        counts.farthest = std::max(counts.farthest, around.distance);
      } else {
        ++counts.elsewhere;
        counts.steps_elsewhere.at(x, y) = step;
        counts.where += " (" + std::to_string(x) + ", " + std::to_string(y) + ")";
      }
    }
  }
  return counts;
}

void expect_wrong_only_near_edges(const ParityCase& parity_case, double band) {
  const BandCounts counts = count_wrong_pixels(parity_case, band);
  std::cout << std::left << std::setw(24) << parity_case.name << std::right << std::fixed
            << std::setprecision(3) << "off by more than 3/255: "
            << 100.0 * static_cast<double>(counts.wrong) / static_cast<double>(counts.pixels)
            << " % (" << counts.wrong << "): " << counts.in_band << " near shadow edges, "
            << std::setprecision(2) << counts.farthest << " texels at most of " << band << "; "
            << counts.at_rim << " at rims, " << counts.grazing << " grazing, " << counts.elsewhere
            << " elsewhere\n";
  EXPECT_EQ(counts.elsewhere, 0u) << counts.where << '\n'
                                  << test_support::show_failure(
                                         file_name(parity_case),
                                         test_support::as_floats(counts.composite),
                                         test_support::as_floats(
                                             reference_images(parity_case).composite),
                                         counts.steps_elsewhere, kLargestStep);
}

TEST(ShadowMaps, AreWrongOnlyNearEdgesOfShadows) {
  for (const int width : {160, 320}) {
    for (const char* scene : {"complex", "diffuse", "mirror"}) {
      const bool has_glass = std::string(scene) == "complex";
      expect_wrong_only_near_edges(make_parity_case(scene, width, width * 3 / 4),
                                   has_glass ? kGlassBand : kBand);
    }
  }
}

TEST(ShadowMaps, OfMadeUpScenesAreWrongOnlyNearEdgesOfShadows) {
  expect_wrong_only_near_edges(make_everything_case(), kGlassBand);
  expect_wrong_only_near_edges(make_materials_case(), kGlassBand);
}

TEST(ShadowMaps, OfBunniesAreWrongOnlyNearEdgesOfShadows) {
  for (const char* scene : {"generated/bunny-glass", "generated/bunny-mirror"}) {
    if (!std::filesystem::exists(scene_path(scene)))
      GTEST_SKIP() << "there is no " << scene_path(scene) << ": deploy/fetch_assets.sh makes it";
    expect_wrong_only_near_edges(make_parity_case(scene, 160, 120), kGlassBand);
  }
}

}  // namespace
}  // namespace amalgam::parity
