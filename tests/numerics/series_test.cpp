// numerics B7 to B9: mirrors that face each other, whose ratio r goes to 1; what a limit of depth
// or importance takes away; and a furnace, in which nothing may be lost.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;
using test_support::make_quad;

constexpr int kDeepest = 10000;  // of RendererSettings

// Two mirrors along z that reflect r and glow with 1 - r, so that endless bounces add up to 1.
scene::Scene facing_mirrors(float r) {
  scene::Scene scene;
  scene::Material mirror = test_support::make_mirror(glm::vec3(r));
  mirror.emission = glm::vec3(1.0f - r);
  add_object(scene, make_quad({0, 0, -1}, {1, 0, 0}, {0, 1, 0}), mirror, scene::Role::Virtual);
  add_object(scene, make_quad({0, 0, 1}, {-1, 0, 0}, {0, 1, 0}), mirror, scene::Role::Virtual);
  return scene;
}

double seen_between(const scene::Scene& mirrors, int depth, float cutoff = 0.0f) {
  return double{trace_ray(mirrors, {0.1, 0.23, 0.0}, {0.1, 0.23, -1.0},
                          {.max_depth = depth, .importance_cutoff = cutoff})
                    .x};
}

struct DepthForAByte {
  float r;
  int depth;
};
constexpr DepthForAByte kDepths[] = {{0.5f, 8},    {0.8f, 25},   {0.9f, 53},
                                     {0.95f, 109}, {0.99f, 552}, {0.999f, 5539}};

TEST(Series, DepthFollowsFromATolerance) {
  for (const auto& [ratio, depth] : kDepths) {
    const double r = double{ratio};
    EXPECT_EQ(std::lround(std::ceil(std::log(1.0 / 255.0) / std::log(r))), depth);
    const scene::Scene mirrors = facing_mirrors(ratio);
    for (const int d : {0, 1, depth / 2, depth}) {
      EXPECT_NEAR(seen_between(mirrors, d), 1.0 - std::pow(r, d + 1), 1e-5) << r << " " << d;
    }
    EXPECT_LT(1.0 - seen_between(mirrors, depth), 1.0 / 255.0) << r;
  }
}

// The error falls by r with each bounce, as long as float resolves it.
TEST(Series, ErrorFallsByTheRatioWithEachBounce) {
  for (const auto& [ratio, depth] : kDepths) {
    const scene::Scene mirrors = facing_mirrors(ratio);
    const int first = depth / 4;
    const double slope =
        std::log((1.0 - seen_between(mirrors, depth)) / (1.0 - seen_between(mirrors, first))) /
        (depth - first);
    EXPECT_NEAR(slope / std::log(double{ratio}), 1.0, 0.01) << ratio;
  }
}

// Beyond: with r nearer to 1 the deepest limit takes r^(D+1) away, and says so.
TEST(Series, TheDeepestLimitIsCounted) {
  const scene::Environment black = constant_environment(0.0f);
  for (const float r : {0.9999f, 0.99999f, 1.0f}) {
    scene::Scene box;
    add_object(box, test_support::make_box(glm::vec3(-1.0f), glm::vec3(1.0f)),
               test_support::make_mirror(glm::vec3(r)), scene::Role::Virtual);
    const TraceResult result =
        trace_shot(box, {.eye = {0.1, 0.2, 0.5},
                         .settings = {.max_depth = kDeepest, .importance_cutoff = 0.0f},
                         .environment = &black,
                         .width = 1,
                         .height = 1,
                         .keep_provenance = true});
    EXPECT_EQ(result.counts.rays.reflection, std::uint64_t{kDeepest}) << r;
    EXPECT_EQ(result.nonfinite, 0u);
    const float cut =
        result.provenance->at(0, 0)[static_cast<std::size_t>(core::LightSource::CutOff)];
    // The slant of the mirrors adds to r: Schlick's term, which at r = 1 is 0.
    EXPECT_GE(double{cut}, (1.0 - 1e-3) * std::pow(double{r}, kDeepest + 1)) << r;
    EXPECT_LE(cut, 1.0f) << r;
  }
}

// numerics B8: what the cut-off takes away in a scene of glowing mirrors lies between r eps and eps
// of the endless sum, so it grows linearly with eps.
TEST(Series, TheCutOffsBiasStaysBelowItsBound) {
  for (const float r : {0.5f, 0.9f, 0.99f, 0.999f}) {
    const scene::Scene mirrors = facing_mirrors(r);
    for (const float cutoff : {0.3f, 0.1f, 0.01f, 1e-3f}) {
      const double bias = 1.0 - seen_between(mirrors, kDeepest, cutoff);
      const double rounding = 1e-5;
      EXPECT_LE(bias, double{cutoff} + rounding) << r << " " << cutoff;
      EXPECT_GE(bias, double{r} * double{cutoff} - rounding) << r << " " << cutoff;
    }
  }
  // Beyond: r = 0.9999 would need 69,075 bounces for a cut-off of 0.001. The depth ends it before.
  EXPECT_NEAR(1.0 - seen_between(facing_mirrors(0.9999f), kDeepest, 1e-3f),
              std::pow(double{0.9999f}, kDeepest + 1), 1e-3);
}

// numerics B9: over the depths at which all branches of glass can be followed, and over all
// radiances of an environment.
TEST(Series, AFurnaceStaysEvenAtAnyDepthAndRadiance) {
  scene::Scene ball;
  add_object(ball, test_support::make_sphere(glm::vec3(0.0f), 0.5f, 20, 12),
             test_support::make_glass(), scene::Role::Virtual);
  const auto worst_error = [&](int depth, float radiance) {
    const scene::Environment furnace = constant_environment(radiance);
    const TraceResult result =
        trace_shot(ball, {.settings = {.max_depth = depth, .importance_cutoff = 0.0f},
                          .environment = &furnace,
                          .width = 12,
                          .height = 12,
                          .focal_length = 20});
    EXPECT_EQ(result.nonfinite, 0u) << radiance;
    double worst = 0.0;
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 12; ++x) {
        if (result.images->met_virtual.at(x, y) == 0) continue;
        const double seen = double{result.images->mixed.at(x, y).x};
        worst = std::max(worst, std::abs(seen / double{radiance} - 1.0));
      }
    }
    return worst;
  };
  for (const int depth : {0, 1, 4, 16, 24}) EXPECT_LT(worst_error(depth, 1.0f), 5e-6) << depth;
  for (const float radiance : {1e-30f, 1e-10f, 65504.0f, 1e30f, 3e38f}) {
    EXPECT_LT(worst_error(8, radiance), 5e-6) << radiance;
  }
  // Beyond: weights times radiance become denormal, or exceed the largest float.
  EXPECT_GT(worst_error(8, 1e-43f), 1e-3);
}

}  // namespace
}  // namespace amalgam::trace
