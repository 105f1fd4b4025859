// The largest radiance that a ray may bring back, against what the tracer shades.
#include "trace/radiance_limit.h"

#include <gtest/gtest.h>

#include <numbers>

#include "scene/light/tone_map.h"
#include "support/scene_builders.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;

RadianceLimit limit_of(const scene::Scene& scene, const std::vector<scene::Light>& lights = {},
                       const scene::Environment* environment = nullptr) {
  EmbreeScene embree(scene);
  embree.place(
      test_support::make_view(scene, test_support::make_pinhole(1, 1, 1), glm::dmat4(1.0), {})
          .scene);
  return find_radiance_limit(
      embree, lights, environment,
      environment != nullptr ? scene::largest_radiance(*environment) : glm::vec3(0.0f), true);
}

scene::Scene with_floor(const scene::Material& material, scene::Role role = scene::Role::Virtual) {
  scene::Scene scene;
  add_object(scene, test_support::make_floor(0.0f, 1.0f), material, role);
  return scene;
}

TEST(RadianceLimit, IsTheBrightestTexelOfTheEnvironment) {
  scene::Environment environment = constant_environment(0.5f);
  environment.radiance.at(1, 1) = glm::vec3(7.0f, 0.25f, 0.5f);
  const scene::Scene scene = with_floor(test_support::make_mirror());
  EXPECT_NEAR(limit_of(scene, {}, &environment).radiance.x, 7.0f, 0.001f);
  EXPECT_NEAR(limit_of(scene, {}, &environment).radiance.y, 0.5f, 0.001f);
  environment.low_dynamic_range = true;
  EXPECT_EQ(limit_of(scene, {}, &environment).radiance, glm::vec3(0.0f));
  EXPECT_NEAR(limit_of(scene, {}, &environment).environment.x, 7.0f, 0.001f);
}

TEST(RadianceLimit, OfAMatteSurfaceIsItsRadianceFacingTheSun) {
  const scene::Scene scene = with_floor(test_support::make_diffuse(glm::vec3(0.5f), 1.0f));
  const scene::PhongTerms terms = scene::phong_terms(glm::vec3(0.5f), 0.0f, 1.0f);
  const float expected =
      terms.albedo.x / std::numbers::pi_v<float> +
      terms.specular.x * (terms.exponent + 2.0f) / (2.0f * std::numbers::pi_v<float>);
  EXPECT_NEAR(limit_of(scene, {test_support::make_sun({0, 1, 0}, glm::vec3(3.0f))}).radiance.x,
              3.0f * expected, 0.001f);
}

// A point light is nowhere nearer to a surface than to its box.
TEST(RadianceLimit, TakesThePointLightsDistanceToTheBox) {
  const scene::Scene scene = with_floor(test_support::make_diffuse(glm::vec3(0.5f)));
  const auto at = [&](const glm::vec3& position) {
    return limit_of(scene, {test_support::make_point_light(position, glm::vec3(1.0f))}).radiance.x;
  };
  EXPECT_NEAR(at({0, 2, 0}) / at({0, 4, 0}), 4.0f, 0.001f);
  EXPECT_NEAR(at({4, 0, 0}) / at({0, 3, 0}), 1.0f, 0.001f);  // 3 from the floor's edge
}

TEST(RadianceLimit, HasNoLimitIfMirrorsEmit) {
  scene::Material lamp = test_support::make_mirror();
  lamp.emission = glm::vec3(0.1f);
  EXPECT_EQ(limit_of(with_floor(lamp)).radiance.x, kNoRadianceLimit);
}

TEST(RadianceLimit, IncludesTheCameraImageIfRealSurfacesCanBeLookedUp) {
  const common::ImageRgb8 image(2, 2, {10, 200, 30});
  const scene::Material grey = test_support::make_diffuse(glm::vec3(0.5f));
  const RadianceLimit real = limit_of(with_floor(grey, scene::Role::Real));
  const float brightest =
      scene::inverse_tone_map(scene::srgb_decode({200, 200, 200}), scene::tone_map_of(2.0f)).x;
  EXPECT_FLOAT_EQ(with_camera_image(real, image, scene::tone_map_of(2.0f)).radiance.x, brightest);
  const RadianceLimit none = limit_of(with_floor(grey));
  EXPECT_EQ(with_camera_image(none, image, scene::tone_map_of(2.0f)).radiance.x, none.radiance.x);
}

// Seen from all sides, under lights from all sides.
TEST(RadianceLimit, NoShadedSurfaceIsBrighter) {
  const scene::Light behind_the_eye = test_support::make_sun({0, 0, 1}, glm::vec3(3.0f));
  for (const float roughness : {0.15f, 0.4f, 1.0f}) {
    scene::Scene scene;
    add_object(scene, test_support::make_sphere(glm::vec3(0.0f), 0.5f),
               test_support::make_diffuse(glm::vec3(0.9f, 0.5f, 0.1f), roughness),
               scene::Role::Virtual);
    const auto brightest = [&](const std::vector<scene::Light>& lights) {
      const TraceResult result =
          trace_shot(scene, {.lights = lights, .width = 65, .height = 65, .focal_length = 80});
      float most = 0.0f;
      for (const glm::vec3& pixel : result.images->mixed.pixels()) most = std::max(most, pixel.x);
      return most;
    };
    const std::vector<scene::Light> many{
        behind_the_eye, test_support::make_sun({1, 0, 0}, glm::vec3(2.0f)),
        test_support::make_point_light({0, 0, 1.0f}, glm::vec3(1.0f))};
    EXPECT_LE(brightest(many), limit_of(scene, many).radiance.x) << roughness;
    // One light that is reflected straight to the eye reaches the limit.
    EXPECT_LE(brightest({behind_the_eye}), limit_of(scene, {behind_the_eye}).radiance.x);
    EXPECT_GE(brightest({behind_the_eye}), 0.9f * limit_of(scene, {behind_the_eye}).radiance.x);
  }
}

}  // namespace
}  // namespace amalgam::trace
