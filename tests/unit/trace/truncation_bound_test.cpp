// The bound on what cutting rays off may have changed, by closed forms and on whole pictures.
#include "trace/truncation_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/scene_builders.h"
#include "trace/tracer.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;

// TM(L) = L / (1 + L).
double compressed(double radiance) {
  return radiance / (1.0 + radiance);
}

TEST(TruncationBound, IsTheFartherEndOfTheRange) {
  // A quarter of the sample was cut off and took .5 x .25; the endless ray brings 0 to 4 x .25.
  SampleResult sample{.mixed = glm::vec3(1.0f), .met_virtual = true};
  const Truncation truncation{.weight = glm::vec3(0.25f), .radiance = glm::vec3(0.125f)};
  const RadianceLimit limit{.radiance = glm::vec3(4.0f)};
  EXPECT_NEAR(truncation_bound(sample, truncation, limit, scene::tone_map_of(1.0f)).x,
              compressed(0.875 + 1.0) - compressed(1.0), 1e-6);
  // A dark limit leaves only the lower end.
  const RadianceLimit dark{.radiance = glm::vec3(0.5f)};
  EXPECT_NEAR(truncation_bound(sample, truncation, dark, scene::tone_map_of(1.0f)).x,
              compressed(1.0) - compressed(0.875), 1e-6);
}

TEST(TruncationBound, EndsWhereALinearCameraClips) {
  const SampleResult sample{.mixed = glm::vec3(0.5f), .met_virtual = true};
  const Truncation truncation{.weight = glm::vec3(0.25f), .radiance = glm::vec3(0.125f)};
  const auto bound = [&](float limit) {
    return truncation_bound(sample, truncation, {.radiance = glm::vec3(limit)},
                            scene::tone_map_of(1.0f, scene::ToneCurve::Linear))
        .x;
  };
  EXPECT_FLOAT_EQ(bound(1.5f), 0.25f);
  EXPECT_FLOAT_EQ(bound(100.0f), 0.5f);
}

TEST(TruncationBound, CountsALowDynamicRangeEnvironmentInDisplayLight) {
  SampleResult sample{
      .mixed = glm::vec3(1.0f), .environment_reflection = glm::vec3(0.2f), .met_virtual = true};
  const Truncation truncation{.weight = glm::vec3(0.25f), .environment = glm::vec3(0.05f)};
  const RadianceLimit limit{.radiance = glm::vec3(4.0f), .environment = glm::vec3(0.8f)};
  EXPECT_NEAR(truncation_bound(sample, truncation, limit, scene::tone_map_of(1.0f)).x,
              compressed(2.0) - compressed(1.0) + 0.25 * 0.8 - 0.05, 1e-6);
}

TEST(TruncationBound, IsEverythingWhereARealMirrorMayStillMeetTheVirtual) {
  const Truncation truncation{.weight = glm::vec3(1e-3f)};
  EXPECT_EQ(truncation_bound({.met_virtual = false}, truncation, {}, scene::tone_map_of(1.0f)),
            glm::vec3(1.0f));
}

TEST(TruncationBound, StaysFiniteWithoutALimit) {
  SampleResult sample{.mixed = glm::vec3(1.0f), .met_virtual = true};
  const Truncation truncation{.weight = glm::vec3(0.25f, 0.25f, 0.0f)};
  const glm::vec3 bound = truncation_bound(
      sample, truncation, {.radiance = glm::vec3(kNoRadianceLimit)}, scene::tone_map_of(1.0f));
  EXPECT_FLOAT_EQ(bound.x, 0.5f);
  EXPECT_FLOAT_EQ(bound.z, 0.0f);
}

TEST(TruncationBound, StaysFiniteForLightThatIsNot) {
  const Truncation truncation{.weight = glm::vec3(0.25f), .radiance = glm::vec3(0.1f)};
  for (const float radiance :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 3e38f}) {
    const SampleResult sample{.mixed = glm::vec3(radiance), .met_virtual = true};
    for (const float limit : {1.0f, kNoRadianceLimit}) {
      const float bound = truncation_bound(sample, truncation, {.radiance = glm::vec3(limit)},
                                           scene::tone_map_of(1e6f))
                              .x;
      EXPECT_GE(bound, 0.0f) << radiance;
      EXPECT_LE(bound, 1.0f) << radiance;
    }
  }
}

// Inside a box of mirrors every ray is cut off, with weight r^(D+1): the environment of radiance 1
// is also the limit, so the true color lies between 0 and what is seen.
TEST(TruncationBound, FollowsTheGeometricSeriesOfFacingMirrors) {
  const scene::Environment environment = constant_environment(1.0f);
  for (const float r : {0.5f, 0.9f, 0.99f}) {
    scene::Scene scene;
    add_object(scene, test_support::make_box(glm::vec3(-1.0f), glm::vec3(1.0f)),
               test_support::make_mirror(glm::vec3(r)), scene::Role::Virtual);
    for (const int depth : {0, 5, 20}) {
      const Shot shot{.eye = {0, 0, 0.5},
                      .settings = {.max_depth = depth, .importance_cutoff = 0.0f},
                      .environment = &environment,
                      .width = 1,
                      .height = 1};
      const TraceResult result = trace_shot(scene, shot);
      const double seen = compressed(std::pow(double{r}, depth + 1));
      EXPECT_NEAR(result.truncation.worst, seen, 2e-6) << r << " " << depth;
      EXPECT_NEAR(result.truncation.sum, seen, 2e-6) << r << " " << depth;
    }
  }
}

TEST(TruncationBound, IsZeroWhereNoRayIsCutOff) {
  const scene::Environment environment = constant_environment(1.0f);
  scene::Scene scene;
  add_object(scene, test_support::make_quad(glm::vec3(0.0f), {1, 0, 0}, {0, 1, 0}),
             test_support::make_mirror(glm::vec3(0.5f)), scene::Role::Virtual);
  const TraceResult result = trace_shot(scene, {.environment = &environment});
  EXPECT_GT(result.counts.rays.reflection, 0u);
  EXPECT_EQ(result.truncation.worst, 0.0);
  EXPECT_EQ(result.truncation.sum, 0.0);
}

}  // namespace
}  // namespace amalgam::trace
