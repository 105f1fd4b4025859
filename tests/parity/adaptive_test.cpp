// Adaptive super-sampling: a refined pixel is what nine samples a pixel give, any other one is what
// one sample gives.
#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>

#include "parity/everything_case.h"
#include "parity/rendering.h"
#include "support/compare_images.h"
#include "support/reference/relative_error.h"

namespace amalgam::parity {
namespace {

using reference::Color;
using reference::Vec4;

// Display-linear, relative as for traced pixels.
constexpr double kTolerance = 2e-3;
// Of all pixels: nine samples graze nine times as much as one (0.2 %).
constexpr double kMostGrazing = 9 * 0.002;

struct LayerImages {
  const common::ImageRgba32f& over;
  const common::ImageRgb32f& difference;
};

LayerImages layers_of(const Rendering& rendering) {
  return {std::get<common::ImageRgba32f>(rendering.buffers.at("over")),
          std::get<common::ImageRgb32f>(rendering.buffers.at("difference"))};
}

double layer_error(const LayerImages& actual, const reference::Layers& expected, int x, int y) {
  const Vec4 over(actual.over.at(x, y)), wanted = expected.over.at(x, y);
  return std::max(
      {reference::relative_error(Color(over), Color(wanted)), std::abs(over.a - wanted.a),
       reference::relative_error(Color(actual.difference.at(x, y)), expected.difference.at(x, y))});
}

bool is_same_pixel(const LayerImages& a, const LayerImages& b, int x, int y) {
  return a.over.at(x, y) == b.over.at(x, y) && a.difference.at(x, y) == b.difference.at(x, y);
}

struct Counts {
  std::size_t changed = 0, grazing = 0, wrong = 0;
  double worst = 0.0;
  common::Image<double> errors;  // of changed pixels that do not graze
};

// Pixels that refinement has changed, against nine samples.
Counts compare_changed(const LayerImages& once, const LayerImages& adaptive,
                       const reference::ReferenceImages& nine) {
  Counts counts;
  counts.errors = common::Image<double>(nine.mixed.width(), nine.mixed.height());
  for (int y = 0; y < nine.mixed.height(); ++y) {
    for (int x = 0; x < nine.mixed.width(); ++x) {
      if (is_same_pixel(once, adaptive, x, y)) continue;
      ++counts.changed;
      if (nine.grazing.at(x, y) != 0) {
        ++counts.grazing;
        continue;
      }
      const double error = layer_error(adaptive, nine.layers, x, y);
      counts.errors.at(x, y) = error;
      counts.worst = std::max(counts.worst, error);
      counts.wrong += error > kTolerance ? 1 : 0;
    }
  }
  return counts;
}

// Layer A, without its coverage.
template <typename Image>
common::ImageRgb32f colors_of(const Image& over) {
  common::ImageRgb32f colors(over.width(), over.height());
  for (std::size_t i = 0; i < colors.pixels().size(); ++i) {
    colors.pixels()[i] = glm::vec3(over.pixels()[i]);
  }
  return colors;
}

void expect_refined_as_nine_samples(const ParityCase& parity_case, frame::RendererMode mode) {
  frame::RendererSettings settings;
  settings.mode = mode;
  const Rendering once = render(parity_case, settings);
  settings.adaptive_threshold = frame::kDefaultAdaptiveThreshold;
  const Rendering adaptive = render(parity_case, settings);
  const reference::ReferenceImages& nine = reference_images(with_samples(parity_case, 3));
  const Counts counts = compare_changed(layers_of(once), layers_of(adaptive), nine);

  const auto pixels = static_cast<double>(parity_case.camera_image.pixels().size());
  const auto refined = static_cast<double>(adaptive.statistics.pixels.refined);
  std::cout << parity_case.name << ", " << mode_name(mode) << ": refined " << std::fixed
            << std::setprecision(2) << 100.0 * refined / pixels << " % of the pixels, changed "
            << counts.changed << " pixels, of those grazing " << counts.grazing << ", wrong "
            << counts.wrong << ", worst error " << std::scientific << counts.worst << '\n';
  EXPECT_EQ(counts.wrong, 0u) << test_support::show_failure(
      "over", colors_of(layers_of(adaptive).over), colors_of(nine.layers.over), counts.errors,
      kTolerance);
  EXPECT_LE(static_cast<double>(counts.changed), refined);
  EXPECT_LE(static_cast<double>(counts.grazing), kMostGrazing * pixels);
  EXPECT_GT(counts.changed, 0u);
}

class Adaptive : public testing::TestWithParam<frame::RendererMode> {};

TEST_P(Adaptive, ComplexSceneIsRefinedAsNineSamples) {
  expect_refined_as_nine_samples(make_parity_case("complex", 160, 120), GetParam());
}

TEST_P(Adaptive, MirrorSceneIsRefinedAsNineSamples) {
  expect_refined_as_nine_samples(make_parity_case("mirror", 160, 120), GetParam());
}

TEST_P(Adaptive, EverythingIsRefinedAsNineSamples) {
  expect_refined_as_nine_samples(make_everything_case(), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Modes, Adaptive,
                         testing::Values(frame::RendererMode::Raytrace,
                                         frame::RendererMode::Hybrid),
                         [](const auto& info) { return std::string(mode_name(info.param)); });

}  // namespace
}  // namespace amalgam::parity
