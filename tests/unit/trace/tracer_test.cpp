#include "trace/tracer.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/light/tone_map.h"
#include "support/scene_builders.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;

// numerics B5: a slab before a lamp transmits (1-R)/(1+R); partial sums by depth.
TEST(Tracer, SlabTransmitsTheSumOfItsInnerBounces) {
  scene::Scene scene;
  add_object(scene, test_support::make_box({-1, -1, 0}, {1, 1, 0.1f}), test_support::make_glass(),
             scene::Role::Virtual);
  add_object(scene, test_support::make_quad({0, 0, -0.5f}, {3, 0, 0}, {0, 3, 0}), emitter(1.0f),
             scene::Role::Virtual);
  const std::pair<int, float> partial_sums[] = {
      {2, 0.9216f}, {4, 0.92307456f}, {6, 0.923076919f}, {40, 0.923077f}};
  for (const auto& [depth, expected] : partial_sums) {
    const Shot shot{.settings = {.max_depth = depth,
                                 .importance_cutoff = 0.0f,
                                 .fresnel = FresnelModel::Exact}};
    EXPECT_NEAR(centre(trace_shot(scene, shot)).x, expected, 2e-6f) << depth;
  }
}

TEST(Tracer, GlassAbsorbsByBeerLambert) {
  scene::Scene scene;
  const glm::vec3 absorption(0.0f, 1.0f, 10.0f);
  add_object(scene, test_support::make_box({-1, -1, 0}, {1, 1, 0.2f}),
             test_support::make_glass(1.0f + 1e-6f, absorption), scene::Role::Virtual);
  add_object(scene, test_support::make_quad({0, 0, -0.5f}, {3, 0, 0}, {0, 3, 0}), emitter(1.0f),
             scene::Role::Virtual);
  const glm::vec3 seen = centre(trace_shot(scene, {}));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], std::exp(-0.2f * absorption[c]), 1e-4f);
}

// A texel that is not there divides no path: what the glass absorbs before and behind it counts
// once.
TEST(Tracer, MaskedSurfacesInGlassDoNotChangeWhatItAbsorbs) {
  scene::Scene scene;
  add_object(scene, test_support::make_box({-1, -1, 0}, {1, 1, 0.2f}),
             test_support::make_glass(1.0f + 1e-6f, glm::vec3(5.0f)), scene::Role::Virtual);
  add_object(scene, test_support::make_quad({0, 0, -0.5f}, {3, 0, 0}, {0, 3, 0}), emitter(1.0f),
             scene::Role::Virtual);
  scene::Material gauze = emitter(9.0f);
  gauze.base_color.a = 0.0f;
  gauze.alpha_cutoff = 0.5f;
  for (const float z : {0.05f, 0.15f}) {
    add_object(scene, test_support::make_quad({0, 0, z}, {1, 0, 0}, {0, 1, 0}), gauze,
               scene::Role::Virtual);
  }
  EXPECT_NEAR(centre(trace_shot(scene, {})).x, std::exp(-1.0f), 1e-4f);
}

// A lamp in a mirror is one bounce away, however many holes the ray goes through.
TEST(Tracer, HolesUseUpNoDepth) {
  scene::Scene scene;
  add_object(scene, test_support::make_quad(glm::vec3(0.0f), {1, 0, 0}, {0, 1, 0}),
             test_support::make_mirror(glm::vec3(0.5f)), scene::Role::Virtual);
  add_object(scene, test_support::make_box({-1, -1, 3}, {1, 1, 4}), emitter(1.0f),
             scene::Role::Virtual);
  scene::Material gauze = emitter(9.0f);
  gauze.base_color.a = 0.0f;
  gauze.alpha_cutoff = 0.5f;
  for (const float z : {0.5f, 1.0f}) {
    add_object(scene, test_support::make_quad({0, 0, z}, {1, 0, 0}, {0, 1, 0}), gauze,
               scene::Role::Virtual);
  }
  EXPECT_EQ(trace_ray(scene, {0, 0, 2}, {0, 0, 0}, {.max_depth = 1}).x, 0.5f);
  EXPECT_EQ(trace_ray(scene, {0, 0, 2}, {0, 0, 0}, {.max_depth = 0}).x, 0.0f);
}

// numerics B7: facing mirrors of reflectance r that see a lamp of radiance e through ... each
// other: the series stops at the depth limit.
TEST(Tracer, FacingMirrorsFollowTheGeometricSeries) {
  // A mirror box seen from inside: every bounce is by r, after D + 1 of them the ray takes the
  // environment.
  const scene::Environment environment = constant_environment(1.0f);
  for (const float r : {0.5f, 0.9f, 0.99f}) {
    scene::Scene scene;
    add_object(scene, test_support::make_box(glm::vec3(-1.0f), glm::vec3(1.0f)),
               test_support::make_mirror(glm::vec3(r)), scene::Role::Virtual);
    for (const int depth : {0, 1, 5, 20, 100}) {
      const Shot shot{.eye = {0, 0, 0.5},
                      .settings = {.max_depth = depth, .importance_cutoff = 0.0f},
                      .environment = &environment,
                      .width = 1,
                      .height = 1};
      EXPECT_NEAR(centre(trace_shot(scene, shot)).x, std::pow(r, depth + 1), 1e-5f)
          << r << " " << depth;
    }
  }
}

// A branch's importance is the largest channel of its weight: a mirror that reflects one color
// alone is followed. What is at the cut-off goes on, what is below ends.
TEST(Tracer, TheLargestChannelDecidesAboutTheCutOff) {
  for (int channel = 0; channel < 3; ++channel) {
    glm::vec3 color(0.0f);
    color[channel] = 0.5f;
    scene::Scene scene;
    add_object(scene, test_support::make_quad(glm::vec3(0.0f), {1, 0, 0}, {0, 1, 0}),
               test_support::make_mirror(color), scene::Role::Virtual);
    add_object(scene, test_support::make_box({-1, -1, 3}, {1, 1, 4}), emitter(1.0f),
               scene::Role::Virtual);
    const auto seen = [&](float cutoff) {
      return trace_ray(scene, {0, 0, 2}, {0, 0, 0}, {.importance_cutoff = cutoff});
    };
    EXPECT_EQ(seen(0.5f), color);
    EXPECT_EQ(seen(0.51f), glm::vec3(0.0f));
  }
}

// numerics B9: in a furnace of radiance 1 any glass looks like the furnace, whatever the depth.
TEST(Tracer, FurnaceHidesGlass) {
  const scene::Environment environment = constant_environment(1.0f);
  scene::Scene scene;
  add_object(scene, test_support::make_sphere(glm::vec3(0.0f), 0.5f, 20, 12),
             test_support::make_glass(), scene::Role::Virtual);
  const Shot shot{.environment = &environment, .width = 48, .height = 48, .focal_length = 60};
  const TraceResult result = trace_shot(scene, shot);
  for (const auto& pixel : {glm::ivec2(24, 24), glm::ivec2(15, 20), glm::ivec2(24, 12)}) {
    EXPECT_NEAR(result.images->mixed.at(pixel.x, pixel.y).x, 1.0f, 1e-4f);
  }
  EXPECT_GT(result.counts.rays.refraction, 0u);
  EXPECT_EQ(result.nonfinite, 0u);
}

// numerics B1: a mirror box seen from inside shows no acne at any distance from the origin, and
// lets no ray out through an edge that it meets exactly (eye and pixels are chosen so that one
// does).
TEST(Tracer, MirrorBoxHasNoAcne) {
  const scene::Environment environment = constant_environment(1.0f);
  for (const double far : {0.0, 1.0, 1e2, 1e3, 1e4}) {
    scene::Scene scene;
    add_object(scene, test_support::make_box(glm::vec3(-1.0f), glm::vec3(1.0f)),
               test_support::make_mirror(glm::vec3(1.0f)), scene::Role::Virtual,
               glm::translate(glm::mat4(1.0f), glm::vec3(far, far, far)));
    const glm::dvec3 origin(far);
    const Shot shot{.eye = origin + glm::dvec3(0.1, 0.2, 0.5),
                    .target = origin,
                    .settings = {.max_depth = 8},
                    .environment = &environment,
                    .width = 64,
                    .height = 64,
                    .focal_length = 40};
    const TraceResult result = trace_shot(scene, shot);
    // Each ray bounces to the limit: fewer rays mean that some escaped through a wall.
    EXPECT_EQ(result.counts.rays.reflection, 64u * 64u * 8u) << far;
  }
}

// A low-dynamic-range environment goes to I_e, a high one to I_m and I_r (section 4.4).
TEST(Tracer, EnvironmentGoesToItsBuffer) {
  scene::Scene scene;
  add_object(scene, test_support::make_quad(glm::vec3(0.0f), {1, 0, 0}, {0, 1, 0}),
             test_support::make_mirror(glm::vec3(0.5f)), scene::Role::Virtual);
  const scene::Environment low = constant_environment(0.8f, true),
                           high = constant_environment(0.8f);
  const TraceResult with_low = trace_shot(scene, {.environment = &low});
  EXPECT_EQ(centre(with_low), glm::vec3(0.0f));
  EXPECT_NEAR(with_low.images->environment_reflection.at(4, 4).x, 0.4f, 1e-5f);
  EXPECT_NEAR(with_low.layers.at(4, 4).over.x, 0.4f, 1e-5f) << "never tone-mapped";
  const TraceResult with_high = trace_shot(scene, {.environment = &high});
  EXPECT_NEAR(centre(with_high).x, 0.4f, 1e-5f);
  EXPECT_NEAR(with_high.layers.at(4, 4).over.x, 0.4f / 1.4f, 1e-5f);
}

// A real mirror that shows nothing virtual changes nothing: M_v = 0 and the difference is 0.
// A real mirror that shows a virtual object is covered by it.
TEST(Tracer, RealMirrorIsCoveredOnlyWhereItShowsSomethingVirtual) {
  scene::Scene scene;
  add_object(scene, test_support::make_quad(glm::vec3(0.0f), {1, 0, 0}, {0, 1, 0}),
             test_support::make_mirror(), scene::Role::Real);
  const scene::Environment environment = constant_environment(0.7f);
  const TraceResult alone = trace_shot(scene, {.environment = &environment});
  EXPECT_TRUE(alone.layers.is_zero());

  // Behind the camera, so that only the mirror sees it.
  add_object(scene, test_support::make_quad({0, 0, 3}, {-0.02f, 0, 0}, {0, 0.02f, 0}),
             emitter(0.3f), scene::Role::Virtual);
  const TraceResult reflecting = trace_shot(scene, {.environment = &environment});
  EXPECT_EQ(reflecting.layers.at(4, 4).over.w, 1.0f);
  EXPECT_NEAR(centre(reflecting).x, 0.3f, 1e-5f);
  EXPECT_EQ(reflecting.layers.at(0, 4).over.w, 0.0f);
}

// Section 4.4: a perfect virtual mirror in front of a real surface that the camera sees shows the
// camera's own color.
TEST(Tracer, PerfectMirrorShowsTheCamerasColors) {
  scene::Scene scene;
  // The floor seen by the camera, and a mirror at 45 degrees that shows it.
  add_object(scene, test_support::make_floor(0.0f, 5.0f),
             test_support::make_diffuse(glm::vec3(0.4f)), scene::Role::Real);
  add_object(scene, test_support::make_quad({0, 0.5f, 0}, {0.2f, 0, 0}, {0, 0.2f, 0}),
             test_support::make_mirror(), scene::Role::Virtual);
  common::ImageRgb8 camera_image(160, 120, common::Rgb8(30, 120, 200));
  const Shot shot{.eye = {0, 1.2, 1.0},
                  .target = {0, 0.3, 0},
                  .camera_image = &camera_image,
                  .width = 160,
                  .height = 120,
                  .focal_length = 60};
  const TraceResult result = trace_shot(scene, shot);
  // The mirror's middle shows the floor at about z = 0.7, which is inside the image.
  const auto at = common::project(
      test_support::make_pinhole(160, 120, 60),
      glm::dvec3(test_support::look_at(shot.eye, shot.target) * glm::dvec4(0, 0.5, 0, 1)));
  ASSERT_TRUE(at);
  const glm::vec4 over = result.layers.at(static_cast<int>(at->x), static_cast<int>(at->y)).over;
  EXPECT_EQ(over.w, 1.0f);
  EXPECT_EQ(scene::srgb_encode(glm::vec3(over)), common::Rgb8(30, 120, 200));
}

// numerics B19: real surfaces seen directly, without anything virtual: the difference is 0 exactly.
TEST(Tracer, NothingVirtualMeansNoDifference) {
  scene::Scene scene;
  add_object(scene, test_support::make_floor(0.0f, 5.0f),
             test_support::make_diffuse(glm::vec3(0.4f), 0.3f), scene::Role::Real);
  add_object(scene, test_support::make_box({-0.2f, 0, -0.2f}, {0.2f, 0.4f, 0.2f}),
             test_support::make_glass(), scene::Role::Real);
  const scene::Environment environment = constant_environment(0.5f);
  common::ImageRgb8 camera_image(64, 48, common::Rgb8(90, 80, 70));
  const TraceResult result = trace_shot(scene, {.eye = {0.5, 1, 2},
                                                .environment = &environment,
                                                .lights = {test_support::make_sun({0.3f, 1, 0.2f})},
                                                .camera_image = &camera_image,
                                                .width = 64,
                                                .height = 48,
                                                .focal_length = 60});
  EXPECT_TRUE(result.layers.is_zero());
}

// numerics B25: the same bits with any number of threads.
TEST(Tracer, ImagesDoNotDependOnThreads) {
  // TBB would start no more workers than there are cores.
  const tbb::global_control workers(tbb::global_control::max_allowed_parallelism, 16);
  const scene::Environment environment = constant_environment(0.5f);
  scene::Scene scene;
  add_object(scene, test_support::make_sphere(glm::vec3(0.0f), 0.5f), test_support::make_glass(),
             scene::Role::Virtual);
  add_object(scene, test_support::make_floor(-0.5f, 3.0f),
             test_support::make_diffuse(glm::vec3(0.6f)), scene::Role::Real);
  const Shot shot{.eye = {0.3, 0.5, 2},
                  .environment = &environment,
                  .lights = {test_support::make_sun({1, 2, 1})},
                  .width = 80,
                  .height = 60,
                  .samples_per_side = 2,
                  .focal_length = 80};
  std::optional<TraceResult> first;
  for (const int threads : {1, 2, 16}) {
    tbb::task_arena arena(threads);
    std::optional<TraceResult> result;
    arena.execute([&] { result = trace_shot(scene, shot); });
    if (!first) {
      first = std::move(result);
      continue;
    }
    EXPECT_EQ(result->layers.over_image(), first->layers.over_image()) << threads;
    EXPECT_EQ(result->layers.difference_image(), first->layers.difference_image()) << threads;
  }
}

// The average of n x n samples lies between what single samples see, and coverage is a share.
TEST(Tracer, SamplesAverageIntoLayers) {
  scene::Scene scene;
  // Covers the right half of the middle pixel of a 1 x 1 image: from x = 0 on.
  add_object(scene, test_support::make_quad({1, 0, 0}, {1, 0, 0}, {0, 1, 0}), emitter(1.0f),
             scene::Role::Virtual);
  const TraceResult result = trace_shot(scene, {.width = 1, .height = 1, .samples_per_side = 2});
  EXPECT_FLOAT_EQ(result.layers.at(0, 0).over.w, 0.5f);
  EXPECT_FLOAT_EQ(result.layers.at(0, 0).over.x, 0.25f) << "half of TM(1) = 1/2";
}

}  // namespace
}  // namespace amalgam::trace
