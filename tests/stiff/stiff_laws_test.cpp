// Closed forms that stiff scenes follow: the error of a corridor, the light that passes a stack.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

#include "frame/frame_renderer.h"
#include "scene/gltf/loader.h"
#include "scene/light/environment.h"
#include "stiff/stiff_case.h"

namespace amalgam::stiff {
namespace {

using test_support::StiffScene;

struct Picture {
  common::ImageRgb32f mixed;  // I_m
  double cut_off = 0.0;       // greatest share of a pixel's light that is of rays cut off
};

Picture straight_view(const StiffScene& stiff, int side, int depth, float cutoff) {
  parity::ParityCase parity_case = make_case(stiff, side, side);
  frame::RendererSettings settings;
  settings.mode = frame::RendererMode::Raytrace;
  settings.exposure = 1.0f;
  settings.trace.max_depth = depth;
  settings.trace.importance_cutoff = cutoff;
  frame::ViewOptions options;
  options.camera = test_support::narrow_camera(side);
  options.keep_pixels = true;
  options.keep_provenance = true;
  frame::FrameRenderer renderer(parity_case.scene, settings);
  frame::ViewState view(options);
  frame::FrameBuffers buffers;
  const frame::FrameOutput output = renderer.render(
      view, {parity_case.camera_image, {test_support::straight_pose(stiff)}}, &buffers);
  EXPECT_EQ(output.statistics.nonfinite, 0u) << stiff.name;
  Picture picture{std::get<common::ImageRgb32f>(buffers.at("mixed"))};
  for (const core::Provenance& pixel : output.provenance.value().pixels()) {
    const float share = pixel[static_cast<std::size_t>(core::LightSource::CutOff)];
    picture.cut_off = std::max(picture.cut_off, static_cast<double>(share));
  }
  return picture;
}

glm::dvec3 mean(const common::ImageRgb32f& image) {
  glm::dvec3 sum(0.0);
  for (const glm::vec3& pixel : image.pixels()) sum += glm::dvec3(pixel);
  return sum / static_cast<double>(image.pixels().size());
}

// Of points (x, y).
double fitted_slope(const std::vector<glm::dvec2>& points) {
  glm::dvec2 middle(0.0);
  for (const glm::dvec2& p : points) middle += p / static_cast<double>(points.size());
  double along = 0.0, squares = 0.0;
  for (const glm::dvec2& p : points) {
    along += (p.x - middle.x) * (p.y - middle.y);
    squares += (p.x - middle.x) * (p.x - middle.x);
  }
  return along / squares;
}

// The depth at which the error has fallen to this share, rounded up to an even number: rays that
// are cut off after an even number of mirrors all look the same way.
int even_depth(double share, double ratio) {
  return 2 * static_cast<int>(std::ceil(0.5 * std::log(share) / std::log(ratio)));
}

class Corridor : public testing::TestWithParam<const char*> {};

// Numerics B7.
TEST_P(Corridor, ErrorFallsWithTheReflectance) {
  const StiffScene stiff = test_support::stiff_scene("corridor-" + std::string(GetParam()) + "-1m");
  const double ratio = test_support::corridor_error_ratio(stiff.parameter);
  std::vector<glm::dvec2> points;
  for (const double share : {0.5, 0.3, 0.15, 0.08, 0.04}) {
    const int depth = even_depth(share, ratio);
    const glm::dvec3 error =
        mean(straight_view(stiff, 4, depth, 0.0f).mixed) - test_support::kCorridorGlow;
    points.emplace_back(depth, std::log(std::abs(error.r)));
  }
  const double slope = fitted_slope(points);
  std::cout << stiff.name << ": slope " << std::setprecision(6) << slope << ", ln r "
            << std::log(ratio) << '\n';
  EXPECT_NEAR(slope / std::log(ratio), 1.0, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Reflectances, Corridor,
                         testing::Values("0.5", "0.8", "0.9", "0.95", "0.99", "0.999"),
                         [](const testing::TestParamInfo<const char*>& info) {
                           return "r0_" + std::string(info.param).substr(2);
                         });

// Followed until a thousandth is left, all corridors shine alike, at each size.
TEST(Corridors, ShineAlikeWhateverTheirReflectance) {
  for (const StiffScene& stiff : test_support::stiff_scenes()) {
    if (stiff.kind != StiffScene::Kind::Corridor) continue;
    const int depth = even_depth(1e-3, stiff.parameter);
    const glm::dvec3 glow = mean(straight_view(stiff, 2, depth, 0.0f).mixed);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(glow[c], test_support::kCorridorGlow[c], 2e-3) << stiff.name;
    }
  }
}

// What passes comes from in front, what is reflected from behind the camera. Light of both is
// known, so the picture tells the transmittance.
double measured_transmittance(const StiffScene& stiff, const Picture& picture) {
  const scene::Scene scene = scene::load_scene(stiff.file);
  const auto blue = [&](float z) {
    return double{scene::sample_environment(scene.environment.value(), {0.0f, 0.0f, z}).b};
  };
  return (mean(picture.mixed).b - blue(1.0f)) / (blue(-1.0f) - blue(1.0f));
}

struct StackCase {
  int sheets;
  float cutoff;
  double most_cut_off;  // or the picture says too little
};

// Light that is cut off goes on in its direction, though some of it would have been turned back:
// the transmittance may err by its share. That falls slowly, because a ray in N sheets has as many
// ways as a walk among 2N steps. 64 sheets with a cut-off of 1e-7 take 15 s a pixel, and a third is
// cut off still.
TEST(Stacks, TransmitWhatTheSeriesSays) {
  for (const auto& [sheets, cutoff, most_cut_off] :
       {StackCase{2, 1e-6f, 1e-5}, StackCase{4, 1e-6f, 3e-4}, StackCase{8, 1e-7f, 4e-3},
        StackCase{16, 1e-6f, 0.08}}) {
    for (const char* size : {"-1mm", "-1m", "-1km"}) {
      const StiffScene stiff = test_support::stiff_scene("stack-" + std::to_string(sheets) + size);
      const Picture picture = straight_view(stiff, 1, 4000, cutoff);
      const double measured = measured_transmittance(stiff, picture);
      const double expected = test_support::stack_transmittance(test_support::kStackIndex, sheets);
      std::cout << stiff.name << ": transmits " << std::setprecision(6) << measured << ", expected "
                << expected << ", cut off " << picture.cut_off << '\n';
      EXPECT_NEAR(measured, expected, picture.cut_off + 1e-5) << stiff.name;
      EXPECT_LT(picture.cut_off, most_cut_off) << stiff.name;
    }
  }
}

// With a cut-off above the reflectance, what any surface reflects is cut off there, and only light
// that is never reflected passes: (1 - R)^2N, with R = 0.04.
TEST(Stacks, TransmitTheFirstTermAloneAboveTheReflectance) {
  for (const int sheets : {2, 4, 8, 16, 32}) {
    const StiffScene stiff = test_support::stiff_scene("stack-" + std::to_string(sheets) + "-1m");
    const Picture picture = straight_view(stiff, 1, 4000, 0.05f);
    EXPECT_NEAR(measured_transmittance(stiff, picture), std::pow(0.96, 2.0 * sheets), 1e-5)
        << stiff.name;
  }
}

// Numerics B5.
TEST(Stacks, OneSheetIsTheSlab) {
  EXPECT_NEAR(test_support::stack_transmittance(1.5, 1), 0.923077, 1e-6);
}

}  // namespace
}  // namespace amalgam::stiff
