#include "trace/shadow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/scene_builders.h"
#include "trace/fresnel.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
const Ray kUp{{0.0f, 0.01f, 0.0f}, {0, 1, 0}, kInfinity};

ShadowAttenuation shadow_of(const scene::Scene& scene, const Ray& ray = kUp) {
  EmbreeScene embree(scene);
  scene::AnchoredScene anchored;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i)
    anchored.instances.push_back({i, glm::mat4(1.0f)});
  embree.place(anchored);
  PassedSurfaces surfaces;
  return trace_shadow(embree, glm::dvec3(ray.origin), ray, surfaces);
}

TEST(Shadow, VirtualOccluderDarkensTheMixedSolutionOnly) {
  scene::Scene scene;
  add_object(scene, test_support::make_floor(1.0f, 1.0f),
             test_support::make_diffuse(glm::vec3(1.0f)), scene::Role::Virtual);
  const ShadowAttenuation attenuation = shadow_of(scene);
  EXPECT_EQ(attenuation.mixed, glm::vec3(0.0f));
  EXPECT_EQ(attenuation.real, glm::vec3(1.0f));
  add_object(scene, test_support::make_floor(2.0f, 1.0f),
             test_support::make_diffuse(glm::vec3(1.0f)), scene::Role::Real);
  EXPECT_EQ(shadow_of(scene).real, glm::vec3(0.0f))
      << "the ray goes on behind the virtual occluder";
}

TEST(Shadow, NothingInTheWayIsExactlyOne) {
  const ShadowAttenuation attenuation = shadow_of(scene::Scene{});
  EXPECT_EQ(attenuation.mixed, glm::vec3(1.0f));
  EXPECT_EQ(attenuation.real, glm::vec3(1.0f));
}

// Two surfaces at normal incidence, 0.96 each, and Beer-Lambert over the slab's 0.2 m.
TEST(Shadow, GlassSlabTransmitsBySurfacesAndAbsorption) {
  scene::Scene scene;
  const glm::vec3 absorption(1.0f, 2.0f, 5.0f);
  add_object(scene, test_support::make_box({-1, 1, -1}, {1, 1.2f, 1}),
             test_support::make_glass(1.5f, absorption), scene::Role::Virtual);
  const ShadowAttenuation attenuation = shadow_of(scene);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(attenuation.mixed[c], 0.96f * 0.96f * std::exp(-absorption[c] * 0.2f), 1e-4f);
  }
  EXPECT_EQ(attenuation.real, glm::vec3(1.0f));
}

// A thin sheet has no inside: whichever side it is met from, nothing is absorbed.
TEST(Shadow, ThinGlassAbsorbsNothing) {
  scene::Material sheet = test_support::make_glass(1.5f, glm::vec3(20.0f));
  sheet.thin = true;
  for (const float towards_light : {1.0f, -1.0f}) {
    scene::Scene scene;
    add_object(scene, test_support::make_quad({0, 1, 0}, {1, 0, 0}, {0, 0, -towards_light}), sheet,
               scene::Role::Virtual);
    // 1 - 2R / (1 + R) with R = 0.04.
    EXPECT_NEAR(shadow_of(scene).mixed.x, 0.96f / 1.04f, 1e-5f) << towards_light;
  }
}

// An air bubble's surface is no interface, however flat the light.
TEST(Shadow, AirCastsNone) {
  EXPECT_EQ(shadow_transmittance(0.05f, 1.0f, false), 1.0f);
  EXPECT_EQ(shadow_transmittance(0.05f, 1.0f, true), 1.0f);
  EXPECT_LT(shadow_transmittance(0.05f, 1.0001f, false), 0.3f);
}

// Asked for the change only, the answer is the same wherever there is one, and "none" elsewhere.
TEST(Shadow, ChangeIsTheDifferenceOfBothSolutions) {
  struct Case {
    bool virtual_glass, virtual_opaque, real_glass, real_opaque;
  };
  for (const Case& c : {Case{false, false, true, false}, Case{false, false, true, true},
                        Case{true, false, false, false}, Case{true, false, true, false},
                        Case{true, true, true, false}, Case{true, false, true, true},
                        Case{false, true, false, false}, Case{false, true, false, true}}) {
    scene::Scene scene;
    const auto add = [&](bool there, float height, const scene::Material& material,
                         scene::Role role) {
      if (there) {
        add_object(scene, test_support::make_box({-1, height, -1}, {1, height + 0.2f, 1}), material,
                   role);
      }
    };
    const auto glass = test_support::make_glass(1.5f, glm::vec3(1.0f, 2.0f, 3.0f));
    const auto opaque = test_support::make_diffuse(glm::vec3(0.5f));
    add(c.virtual_glass, 1.0f, glass, scene::Role::Virtual);
    add(c.virtual_opaque, 2.0f, opaque, scene::Role::Virtual);
    add(c.real_glass, 3.0f, glass, scene::Role::Real);
    add(c.real_opaque, 4.0f, opaque, scene::Role::Real);
    EmbreeScene embree(scene);
    scene::AnchoredScene anchored;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i)
      anchored.instances.push_back({i, glm::mat4(1.0f)});
    embree.place(anchored);
    PassedSurfaces surfaces;
    const glm::dvec3 start(kUp.origin);
    const ShadowAttenuation both = trace_shadow(embree, start, kUp, surfaces);
    const ShadowAttenuation change = trace_shadow_change(embree, start, kUp, surfaces);
    EXPECT_EQ(change.mixed - change.real, both.mixed - both.real);
    EXPECT_EQ(change.differs(), both.differs());
  }
}

// Light that passes more surfaces than are kept is cut off rather than half counted.
TEST(Shadow, MoreSurfacesThanAreKeptAreDark) {
  scene::Scene scene;
  const auto glass = test_support::make_glass(1.0f, glm::vec3(0.0f));  // as air
  const Ray beside_edges{{0.3f, 0.01f, 0.1f}, {0, 1, 0}, kInfinity};   // where hits come in pairs
  for (int i = 0; i < 140; ++i) {
    const float height = 1.0f + 0.1f * static_cast<float>(i);
    add_object(scene, test_support::make_box({-1, height, -1}, {1, height + 0.05f, 1}), glass,
               scene::Role::Virtual);
    if (i == 100) {
      EXPECT_EQ(shadow_of(scene, beside_edges).mixed, glm::vec3(1.0f));
    }
  }
  EXPECT_EQ(shadow_of(scene, beside_edges).mixed, glm::vec3(0.0f));
}

TEST(Shadow, OccluderBehindTheLightDoesNotCount) {
  scene::Scene scene;
  add_object(scene, test_support::make_floor(2.0f, 1.0f),
             test_support::make_diffuse(glm::vec3(1.0f)), scene::Role::Real);
  Ray to_lamp = kUp;
  to_lamp.t_max = 1.5f;
  EXPECT_EQ(shadow_of(scene, to_lamp).real, glm::vec3(1.0f));
}

}  // namespace
}  // namespace amalgam::trace
