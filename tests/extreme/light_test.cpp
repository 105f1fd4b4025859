// Environments and lamps at and beyond the end of the scale.
#include <gtest/gtest.h>

#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "codec/exr.h"
#include "extreme/desk.h"
#include "scene/gltf/environment_loader.h"
#include "support/compare_images.h"
#include "support/scene_builders.h"

namespace amalgam::extreme {
namespace {

using scene::Environment;

parity::ParityCase desk_under(Environment environment) {
  parity::ParityCase desk = make_desk();
  desk.scene.punctual_lights.clear();
  desk.scene.environment = std::move(environment);
  return desk;
}

TEST(ExtremeEnvironment, OfOneTexel) {
  parity::ParityCase desk = desk_under({common::ImageRgb32f(1, 1, {0.7f, 0.5f, 0.3f}), false});
  desk.name = "one texel";
  expect_right(desk);
}

// Whatever clear glass and white mirrors do with rays, all of them end in the same light.
TEST(ExtremeEnvironment, OfOneTexelIsAFurnace) {
  parity::ParityCase desk = desk_under({common::ImageRgb32f(1, 1, {0.7f, 0.5f, 0.3f}), false});
  desk.scene.instances.clear();
  test_support::add_object(desk.scene, test_support::make_sphere(glm::vec3(0.0f), 0.2f),
                           test_support::make_glass(2.42f), scene::Role::Virtual);
  test_support::add_object(desk.scene,
                           test_support::make_box({0.3f, -0.1f, -0.1f}, {0.35f, 0.3f, 0.1f}),
                           test_support::make_mirror(glm::vec3(1.0f)), scene::Role::Virtual);
  const parity::Rendering picture = render(desk, frame::RendererMode::Hybrid);
  const auto& mixed = std::get<common::ImageRgb32f>(picture.buffers.at("mixed"));
  std::size_t seen = 0;
  for (const glm::vec3& pixel : mixed.pixels()) {
    if (pixel == glm::vec3(0.0f)) continue;
    ++seen;
    EXPECT_NEAR(pixel.r, 0.7, 1e-5);
    EXPECT_NEAR(pixel.g, 0.5, 1e-5);
    EXPECT_NEAR(pixel.b, 0.3, 1e-5);
  }
  EXPECT_GT(seen, mixed.pixels().size() / 10);
}

TEST(ExtremeEnvironment, OfASingleSunOfAMillion) {
  Environment sun{common::ImageRgb32f(64, 32), false};
  sun.radiance.at(40, 8) = glm::vec3(1e6f);
  parity::ParityCase desk = desk_under(std::move(sun));
  desk.name = "sun";
  desk.exposure = 1e-4f;
  expect_right(desk);
}

TEST(ExtremeEnvironment, AllBlack) {
  parity::ParityCase desk = desk_under({common::ImageRgb32f(64, 32), false});
  desk.name = "black";
  expect_right(desk);
}

// The meter has nothing to go by, in the dark and in a light that no display could show.
TEST(ExtremeEnvironment, MeteredPicturesAreFinite) {
  for (const float radiance : {0.0f, 1e-30f, 65504.0f}) {
    const parity::ParityCase desk =
        desk_under({common::ImageRgb32f(4, 2, glm::vec3(radiance)), false});
    frame::RendererSettings settings;
    settings.mode = frame::RendererMode::Raytrace;  // meters like the other
    frame::FrameRenderer renderer(desk.scene, settings);
    frame::ViewOptions options;
    options.camera = desk.camera;
    options.keep_pixels = true;
    frame::ViewState view(options);
    const frame::FrameOutput output = renderer.render(view, {desk.camera_image, desk.poses});
    EXPECT_EQ(output.statistics.nonfinite, 0u) << radiance;
    EXPECT_TRUE(std::isfinite(output.statistics.exposure.y)) << radiance;
    EXPECT_GT(output.statistics.exposure.y, 0.0f) << radiance;
  }
}

TEST(ExtremeEnvironment, AllNanIsBlackWithANote) {
  const auto path = std::filesystem::path(testing::TempDir()) / "amalgam_nan.exr";
  codec::write_exr(path, common::ImageRgb32f(8, 4, glm::vec3(std::nanf(""))));
  std::vector<std::string> notes;
  const parity::ParityCase nan = desk_under(scene::load_environment(path, notes));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("96 NaN"), std::string::npos) << notes[0];
  const parity::ParityCase black = desk_under({common::ImageRgb32f(8, 4), false});
  for (const auto mode : {frame::RendererMode::Raytrace, frame::RendererMode::Hybrid}) {
    EXPECT_TRUE(test_support::images_are_same("nan", render(nan, mode).composite,
                                              render(black, mode).composite));
  }
}

void move_lamp(parity::ParityCase& desk, const glm::vec3& position, const glm::vec3& intensity) {
  desk.scene.punctual_lights.at(0).anchor_from_light = glm::translate(glm::mat4(1.0f), position);
  desk.scene.punctual_lights.at(0).intensity = intensity;
}

TEST(ExtremeLamp, AMillimetreAboveTheFloor) {
  parity::ParityCase desk = make_desk();
  move_lamp(desk, {0.05f, 0.001f, 0.2f}, glm::vec3(0.02f));
  desk.name = "lamp on the floor";
  expect_right(desk);
}

// In a surface, a lamp's light passes or not by chance.
TEST(ExtremeLamp, InASurfaceIsFinite) {
  for (const glm::vec3& position : {glm::vec3(0.05f, 0.0f, 0.2f), {0.1f, 0.15f, -0.15f}}) {
    parity::ParityCase desk = make_desk();
    move_lamp(desk, position, glm::vec3(0.02f));
    for (const auto mode : {frame::RendererMode::Raytrace, frame::RendererMode::Hybrid}) {
      EXPECT_EQ(render(desk, mode).statistics.nonfinite, 0u);
    }
  }
}

// The closed form at the smallest distance: intensity / distance^2, not cut off.
TEST(ExtremeLamp, AFewMicrometresAway) {
  const scene::Light lamp = test_support::make_point_light({0.0f, 2e-5f, 0.0f}, glm::vec3(1e-9f));
  const scene::LightArrival arrival = scene::light_arrival(lamp, glm::vec3(0.0f));
  EXPECT_NEAR(arrival.irradiance.g, 1e-9 / (2e-5 * 2e-5), 1e-6);
  EXPECT_NEAR(arrival.to_light.y, 1.0, 1e-6);
}

// A desk of a millimetre with a lamp at a tenth of that.
TEST(ExtremeLamp, OnADeskOfAMillimetre) {
  parity::ParityCase desk = make_desk(1e-3);
  move_lamp(desk, {0.05e-3f, 0.06e-3f, 0.2e-3f}, glm::vec3(1e-9f));
  desk.name = "lamp at 60 um";
  expect_right(desk);
}

// From so far away a lamp is a sun. As bright a directional light gives the same picture.
TEST(ExtremeLamp, AsFarAsNumbersGoIsASun) {
  constexpr float kFar = 1e15f;
  const glm::vec3 to_light = glm::normalize(glm::vec3(0.4f, 1.0f, 0.3f));
  parity::ParityCase lamp = make_desk(), sun = make_desk();
  move_lamp(lamp, kFar * to_light, glm::vec3(kFar * kFar));
  scene::PunctualLight& light = sun.scene.punctual_lights.at(0);
  light.kind = scene::PunctualLight::Kind::Directional;
  light.intensity = glm::vec3(1.0f);
  // It shines along its -Z.
  light.anchor_from_light = glm::mat4(glm::mat3(glm::dmat3(
      common::rigid_inverse(test_support::look_at(glm::dvec3(to_light), glm::dvec3(0.0))) *
      glm::dmat4(1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1))));
  const test_support::Tolerance same = {1.0, 0.01, "1/255: rounding to bytes", 2};
  const parity::Rendering actual = render(lamp, frame::RendererMode::Raytrace);
  const parity::Rendering expected = render(sun, frame::RendererMode::Raytrace);
  EXPECT_EQ(actual.statistics.nonfinite, 0u);
  EXPECT_TRUE(test_support::images_agree("sun", test_support::as_floats(actual.composite),
                                         test_support::as_floats(expected.composite), same));
  // Rasterised, only finite: a lamp's shadow map covers a sixth of all directions, so that from a
  // hundred desks away the whole desk is less than a texel of it.
  EXPECT_EQ(render(lamp, frame::RendererMode::Hybrid).statistics.nonfinite, 0u);
}

}  // namespace
}  // namespace amalgam::extreme
