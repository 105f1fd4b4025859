// Kept paths with another camera image are what tracing again gives, to the bit.
#include <gtest/gtest.h>

#include "scene/light/tone_map.h"
#include "trace/add_look_ups.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

// A real floor and wall, and a virtual glass ball and mirror between them.
scene::Scene make_scene() {
  scene::Scene scene;
  test_support::add_object(scene, test_support::make_floor(-0.4f, 3.0f),
                           test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  test_support::add_object(scene, test_support::make_sphere({0.0f, 0.0f, 0.0f}, 0.3f),
                           test_support::make_glass(), scene::Role::Virtual);
  test_support::add_object(scene, test_support::make_quad({0, 0, -1}, {1, 0, 0}, {0, 1, 0}),
                           test_support::make_mirror(), scene::Role::Virtual);
  return scene;
}

common::ImageRgb8 ramp(int size, int red) {
  common::ImageRgb8 image(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) image.at(x, y) = common::Rgb8(red, 3 * x, 255 - 3 * y);
  }
  return image;
}

class LookUpAgain : public testing::Test {
 protected:
  static constexpr int kSize = 64;
  static constexpr scene::RealSurfaces kRealSurfaces = scene::RealSurfaces::Ratio;

  TraceResult trace_with(const common::ImageRgb8& image, float exposure, std::size_t keep_below) {
    return trace({.scene = embree_,
                  .lights = lights_,
                  .environment = &environment_,
                  .camera = camera_,
                  .camera_from_world = camera_from_world_,
                  .samples_per_side = 2,
                  .lookup = &lookup_,
                  .camera_image = &image,
                  .tone_map = scene::tone_map_of(exposure),
                  .real_surfaces = kRealSurfaces,
                  .settings = {},
                  .keep_paths_below = keep_below});
  }

  void SetUp() override { embree_.place(anchor_all(scene_)); }

  scene::Scene scene_ = make_scene();
  EmbreeScene embree_{scene_};
  scene::Environment environment_ = constant_environment(0.5f);
  std::vector<scene::Light> lights_{{.to_light = {0, 1, 0}, .intensity = glm::vec3(2.0f)}};
  common::CameraModel camera_ = test_support::make_pinhole(kSize, kSize, 60.0);
  glm::dmat4 camera_from_world_ = test_support::look_at({0, 0.4, 2}, {0, 0, 0});
  CameraView lookup_{.camera = camera_, .camera_from_world = camera_from_world_, .ideal = camera_};
};

TEST_F(LookUpAgain, GivesWhatTracingAgainGives) {
  const TraceResult first = trace_with(ramp(kSize, 40), 1.0f, std::size_t{1} << 30);
  ASSERT_NE(first.paths, nullptr);
  std::size_t look_ups = 0;
  for (const TilePaths& tile : first.paths->tiles) look_ups += tile.look_ups.size();
  EXPECT_GT(look_ups, 1000u);  // or the test tests nothing

  const common::ImageRgb8 image = ramp(kSize, 200);
  const TraceResult again =
      look_up_again(*first.paths, image, scene::tone_map_of(1.7f), kRealSurfaces);
  const TraceResult anew = trace_with(image, 1.7f, 0);
  EXPECT_EQ(again.layers.over_image(), anew.layers.over_image());
  EXPECT_EQ(again.layers.difference_image(), anew.layers.difference_image());
  EXPECT_NE(again.layers.over_image(), first.layers.over_image());
  EXPECT_EQ(again.counts.samples, anew.counts.samples);
  EXPECT_EQ(again.counts.rays.cast(), 0u);
  EXPECT_EQ(again.counts.rays.reused, anew.counts.rays.cast());
  EXPECT_EQ(anew.paths, nullptr);
}

// The same kept paths serve any number of frames: looking up must not add to them.
TEST_F(LookUpAgain, LeavesThePathsAsTheyWere) {
  const common::ImageRgb8 image = ramp(kSize, 90);
  const TraceResult first = trace_with(image, 1.0f, std::size_t{1} << 30);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(look_up_again(*first.paths, image, scene::tone_map_of(1.0f), kRealSurfaces)
                  .layers.over_image(),
              first.layers.over_image());
  }
}

TEST_F(LookUpAgain, PathsThatTakeTooMuchMemoryAreNotKept) {
  const common::ImageRgb8 image = ramp(kSize, 90);
  const std::size_t bytes = trace_with(image, 1.0f, std::size_t{1} << 30).paths->bytes();
  EXPECT_EQ(trace_with(image, 1.0f, bytes / 2).paths, nullptr);
}

// L + (m - r) or L m / r of one look-up, and never less than nothing, however much darker than its
// model a surface is.
TEST(AddLookUps, ChangesWhatTheCameraSees) {
  const common::ImageRgb8 image(1, 1, common::Rgb8(128));
  const float seen =
      scene::inverse_tone_map(scene::srgb_decode(image.at(0, 0)), scene::tone_map_of(1.0f)).x;
  const auto added = [&](float mixed, float real, float trust,
                         scene::RealSurfaces way = scene::RealSurfaces::Difference) {
    TilePaths paths;
    paths.samples.resize(1);
    paths.look_ups.push_back({glm::vec3(0.5f), 0, {}, trust, glm::vec3(mixed), glm::vec3(real)});
    add_look_ups(paths, image, scene::tone_map_of(1.0f), way);
    return glm::vec2(paths.samples[0].mixed.x, paths.samples[0].real.x);
  };
  EXPECT_EQ(added(2.0f, 2.0f, 1.0f), glm::vec2(0.5f * seen));
  EXPECT_EQ(added(2.25f, 2.0f, 1.0f), glm::vec2(0.5f * (seen + 0.25f), 0.5f * seen));
  EXPECT_EQ(added(2.0f, 20.0f, 1.0f), glm::vec2(0.0f, 0.5f * seen));
  EXPECT_EQ(added(2.0f, 20.0f, 0.0f), glm::vec2(1.0f, 10.0f)) << "without trust as modelled";
  const auto by_ratio = scene::RealSurfaces::Ratio;
  EXPECT_EQ(added(2.0f, 2.0f, 1.0f, by_ratio), glm::vec2(0.5f * seen));
  EXPECT_FLOAT_EQ(added(2.0f, 8.0f, 1.0f, by_ratio).x, 0.125f * seen);
  EXPECT_EQ(added(0.0f, 8.0f, 1.0f, by_ratio), glm::vec2(0.0f, 0.5f * seen));
}

}  // namespace
}  // namespace amalgam::trace
