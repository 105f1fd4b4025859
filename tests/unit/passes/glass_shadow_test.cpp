// Glass shadow maps against closed forms of light that goes straight through (shaders/shadow.glsl).

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "support/scene_builders.h"
#include "unit/passes/raster_rig.h"

namespace amalgam::passes {
namespace {

using namespace test_support;

double schlick(double ior, double cosine) {
  const double r0 = std::pow((ior - 1.0) / (ior + 1.0), 2.0);
  return r0 + (1.0 - r0) * std::pow(1.0 - cosine, 5.0);
}

// A floor of 1 m seen whole from above, with the glass to be tested above it; the light is made to
// pass through the glass on its way to the middle of the floor.
struct Attenuation {
  glm::dvec3 mixed, real;
};
Attenuation measure(const scene::Mesh& glass, const scene::Material& material, scene::Role role,
                    const scene::Light& light) {
  scene::Scene scene;
  add_object(scene, make_floor(0.0f, 0.5f), make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  scene::Scene with_glass = scene;
  add_object(with_glass, glass, material, role);
  // Looks from below the glass at the middle of the floor.
  const common::CameraModel camera = make_pinhole(16, 16, 64.0);
  const glm::dmat4 camera_from_world = look_at({0.05, 0.05, 0.05}, {0, 0, 0});
  RasterRig bare_rig(scene), rig(with_glass);
  const RasterFrame bare = bare_rig.render(make_view(scene, camera, camera_from_world, {light}));
  const RasterFrame frame = rig.render(make_view(with_glass, camera, camera_from_world, {light}));
  const glm::dvec3 unshadowed(bare.mixed->at(8, 8));
  return {glm::dvec3(frame.mixed->at(8, 8)) / unshadowed,
          glm::dvec3(frame.real->at(8, 8)) / unshadowed};
}

void expect_equal(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << i;
}

TEST(GlassShadow, OfASlab) {
  scene::Material material = make_glass(1.5f, {1.0f, 4.0f, 10.0f});
  material.base_color = {0.9f, 1.0f, 0.8f, 1.0f};
  const scene::Mesh slab = make_box({-0.3f, 0.2f, -0.3f}, {0.3f, 0.3f, 0.3f});  // 0.1 m thick
  for (const glm::dvec3& direction : {glm::dvec3(0, 1, 0), glm::dvec3(0.5, 1, 0.3)}) {
    const double cosine = glm::normalize(direction).y;
    const double through = 1.0 - schlick(1.5, cosine);
    const glm::dvec3 color(material.base_color);
    const glm::dvec3 expected = through * through * color * color *
                                glm::exp(-glm::dvec3(material.absorption) * (0.1 / cosine));
    const Attenuation got =
        measure(slab, material, scene::Role::Virtual, make_sun(glm::vec3(direction)));
    expect_equal(got.mixed, expected, 1e-5);
    expect_equal(got.real, glm::dvec3(1.0), 1e-6);
    const Attenuation of_real =
        measure(slab, material, scene::Role::Real, make_sun(glm::vec3(direction)));
    expect_equal(of_real.mixed, expected, 1e-5);
    expect_equal(of_real.real, expected, 1e-5);
  }
}

TEST(GlassShadow, OfASlabUnderAPointLight) {
  const scene::Material material = make_glass(1.5f, {1.0f, 4.0f, 10.0f});
  const scene::Mesh slab = make_box({-0.3f, 0.2f, -0.3f}, {0.3f, 0.3f, 0.3f});
  const glm::dvec3 position(0.2, 0.7, 0.1);
  const double cosine = glm::normalize(position).y;
  const double through = 1.0 - schlick(1.5, cosine);
  const glm::dvec3 expected =
      through * through * glm::exp(-glm::dvec3(material.absorption) * (0.1 / cosine));
  const Attenuation got = measure(slab, material, scene::Role::Virtual,
                                  make_point_light(glm::vec3(position), glm::vec3(1.0f)));
  expect_equal(got.mixed, expected, 5e-4);  // a texel is a direction: 1.4e-3 rad of 4.7
}

TEST(GlassShadow, OfThinGlassHasNoAbsorption) {
  scene::Material material = make_glass(1.5f, glm::vec3(50.0f));
  material.thin = true;
  const double r = schlick(1.5, 1.0);
  const Attenuation got = measure(make_quad({0, 0.2f, 0}, {0.3f, 0, 0}, {0, 0, -0.3f}), material,
                                  scene::Role::Virtual, make_sun({0, 1, 0}));
  expect_equal(got.mixed, glm::dvec3(1.0 - 2.0 * r / (1.0 + r)), 1e-6);
}

// Mirrored instances keep their outside: light gets darker in them, not brighter.
TEST(GlassShadow, OfAMirroredSphere) {
  scene::Scene scene;
  add_object(scene, make_floor(0.0f, 0.5f), make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  glm::mat4 mirror(1.0f);
  mirror[0][0] = -1.0f;
  add_object(scene, make_sphere({0, 0.2f, 0}, 0.1f, 64, 32), make_glass(1.5f, glm::vec3(8.0f)),
             scene::Role::Virtual, mirror);
  RasterRig rig(scene);
  const RasterFrame frame =
      rig.render(make_view(scene, make_pinhole(16, 16, 64.0),
                           look_at({0.05, 0.05, 0.05}, {0, 0, 0}), {make_sun({0, 1, 0})}));
  const double through = 1.0 - schlick(1.5, 1.0);
  const double expected = through * through * std::exp(-8.0 * 0.2);
  EXPECT_NEAR(frame.mixed->at(8, 8).x / frame.real->at(8, 8).x, expected, 1e-3);
}

// An air bubble's surface is no interface, however flat the light.
TEST(GlassShadow, OfAirIsNone) {
  const Attenuation got =
      measure(make_box({-0.9f, 0.05f, -0.9f}, {0.9f, 0.1f, 0.9f}), make_glass(1.0f),
              scene::Role::Virtual, make_sun({1.0f, 0.15f, 0.0f}));
  expect_equal(got.mixed, glm::dvec3(1.0), 1e-6);
}

TEST(GlassShadow, DoesNotFallTowardsTheLight) {
  // Glass under a floor that is lit from above.
  const Attenuation got =
      measure(make_box({-0.3f, -0.3f, -0.3f}, {0.3f, -0.2f, 0.3f}),
              make_glass(1.5f, glm::vec3(10.0f)), scene::Role::Virtual, make_sun({0, 1, 0}));
  expect_equal(got.mixed, glm::dvec3(1.0), 1e-6);
}

}  // namespace
}  // namespace amalgam::passes
