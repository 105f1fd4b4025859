// What arrives from lights, and what is left of it behind glass: eq. 4.6 and section 4.3.
#include <gtest/gtest.h>

#include <cmath>

#include "parity/closed_form_rig.h"
#include "support/reference/arriving_light.h"
#include "support/reference/phong.h"

namespace amalgam::reference {
namespace {

using scene::Role;
using test_support::make_box;
using test_support::make_diffuse;
using test_support::make_floor;
using test_support::make_glass;
using test_support::make_point_light;
using test_support::make_quad;
using test_support::make_sun;

// A real white floor under a vertical sun of irradiance 3.
ClosedFormRig sunny_floor() {
  ClosedFormRig rig;
  rig.add(make_floor(0.0f, 9.0f), make_diffuse(glm::vec3(1.0f)), Role::Real);
  rig.lights.push_back(make_sun({0.0f, 1.0f, 0.0f}));
  return rig;
}

const Vec3 kEye(3.1, 1.0, 0.23);  // sees the floor at (0.1, 0, 0.23) past what is above it
const Vec3 kDown = Vec3(0.1, 0.0, 0.23) - kEye;

TEST(ReferenceLight, PhongOnAFloor) {
  ClosedFormRig rig = sunny_floor();
  const Sample sample = rig.trace(kEye, kDown);
  // Roughness 1: exponent 0, the lobe is 1 everywhere, (n + 2) / (2 pi) = 1 / pi.
  EXPECT_NEAR(sample.real.r, 3.0 * (0.96 + 0.04) / kPi, 1e-7);
  EXPECT_EQ(sample.mixed, sample.real);
  EXPECT_FALSE(sample.met_virtual);
}

TEST(ReferenceLight, ShadowOfASlabByRole) {
  const glm::vec3 sigma(0.5f, 1.0f, 2.0f);
  scene::Material glass = make_glass(1.5f, sigma);
  glass.base_color = {0.5f, 1.0f, 0.75f, 1.0f};
  const Color lit = sunny_floor().trace(kEye, kDown).real;
  const Color tint(0.5, 1.0, 0.75);
  const Color expected = lit * tint * tint * (0.96 * 0.96) * glm::exp(-Color(sigma) * 0.5);
  for (const Role role : {Role::Virtual, Role::Real}) {
    ClosedFormRig rig = sunny_floor();
    rig.add(make_box({-1.0f, 2.0f, -1.0f}, {1.0f, 2.5f, 1.0f}), glass, role);
    const Sample sample = rig.trace(kEye, kDown);
    EXPECT_LT(glm::length(sample.mixed - expected), 1e-12);
    EXPECT_LT(glm::length(sample.real - (role == Role::Real ? expected : lit)), 1e-12);
  }
}

TEST(ReferenceLight, ShadowOfAThinSheetAtAnAngle) {
  ClosedFormRig rig = sunny_floor();
  const Color lit = rig.trace(kEye, kDown).real;
  scene::Material sheet = make_glass(1.5f, glm::vec3(7.0f));
  sheet.thin = true;
  // Turned by 60 degrees against the sun.
  rig.add(make_quad({0.0f, 2.0f, 0.0f}, {0.5f, 0.8660254f, 0.0f}, {0.0f, 0.0f, -1.0f}), sheet);
  const double f = schlick(0.04, 0.5), passing = 1.0 - 2.0 * f / (1.0 + f);
  EXPECT_LT(glm::length(rig.trace(kEye, kDown).mixed - lit * passing), 1e-7);
}

TEST(ReferenceLight, BlockersByRole) {
  for (const Role role : {Role::Virtual, Role::Real}) {
    ClosedFormRig rig = sunny_floor();
    const Color lit = rig.trace(kEye, kDown).real;
    rig.add(make_box({-1.0f, 2.0f, -1.0f}, {1.0f, 2.5f, 1.0f}), test_support::make_mirror(), role);
    const Sample sample = rig.trace(kEye, kDown);
    EXPECT_EQ(sample.mixed, Color(0.0));
    EXPECT_EQ(sample.real, role == Role::Real ? Color(0.0) : lit);
  }
}

TEST(ReferenceLight, BehindTheLightNothingCastsAShadow) {
  ClosedFormRig rig;
  rig.add(make_floor(0.0f, 9.0f), make_diffuse(glm::vec3(1.0f)), Role::Real);
  rig.lights.push_back(make_point_light({0.1f, 1.5f, 0.23f}, glm::vec3(2.0f)));
  const Color lit = rig.trace(kEye, kDown).real;
  // Float positions in the light: 0.1f is not 0.1.
  EXPECT_NEAR(lit.r, 2.0 / (1.5 * 1.5) / kPi, 1e-7);
  rig.add(make_box({-1.0f, 2.0f, -1.0f}, {1.0f, 2.5f, 1.0f}), test_support::make_mirror());
  EXPECT_EQ(rig.trace(kEye, kDown).mixed, lit);
}

TEST(ReferenceLight, MaskedOutSurfacesAreNotThere) {
  ClosedFormRig rig = sunny_floor();
  const Color lit = rig.trace(kEye, kDown).real;
  scene::Material leaf = make_diffuse(glm::vec3(1.0f));
  leaf.alpha_cutoff = 0.5f;
  leaf.base_color.a = 0.4f;
  rig.add(make_box({-1.0f, 0.5f, -1.0f}, {9.0f, 2.5f, 1.0f}), leaf);
  const Sample sample = rig.trace(kEye, kDown);
  EXPECT_EQ(sample.mixed, lit);
  EXPECT_FALSE(sample.met_virtual);
}

TEST(ReferenceLight, NothingPassesBelowTheSurface) {
  ClosedFormRig rig = sunny_floor();
  rig.lights = {make_sun({0.0f, -1.0f, 0.0f})};
  EXPECT_EQ(rig.trace(kEye, kDown).mixed, Color(0.0));
  // Seen from below the floor is turned around and lit by that very light.
  EXPECT_GT(rig.trace({0.1, -1.0, 0.23}, {0.0, 1.0, 0.0}).mixed.r, 0.5);
}

TEST(ReferenceLight, FallsOffWithDistanceRangeAndCone) {
  scene::Light light = make_point_light(glm::vec3(0.0f), glm::vec3(8.0f));
  EXPECT_NEAR(arriving_light(light, {0.0, 0.0, 2.0}).irradiance.r, 2.0, 1e-12);
  EXPECT_NEAR(arriving_light(light, Vec3(0.0)).distance, 1e-6, 1e-15);
  light.range = 4.0f;
  EXPECT_NEAR(arriving_light(light, {0.0, 0.0, 2.0}).irradiance.r, 2.0 * (1.0 - 1.0 / 16.0), 1e-12);
  EXPECT_EQ(arriving_light(light, {0.0, 0.0, 4.5}).irradiance.r, 0.0);

  light.range = 0.0f;
  light.kind = scene::Light::Kind::Spot;
  light.to_light = {0.0f, 1.0f, 0.0f};  // shines down
  light.cos_inner = 0.75f;
  light.cos_outer = 0.5f;
  EXPECT_NEAR(arriving_light(light, {0.0, -2.0, 0.0}).irradiance.r, 2.0, 1e-12);
  const double sine = std::sqrt(1.0 - 0.625 * 0.625);  // halfway between the cones: 0.5 squared
  EXPECT_NEAR(arriving_light(light, {2.0 * sine, -1.25, 0.0}).irradiance.r, 0.5, 1e-12);
  EXPECT_EQ(arriving_light(light, {2.0, -1.0, 0.0}).irradiance.r, 0.0);
}

TEST(ReferenceLight, PhongReflectsNoMoreThanItReceives) {
  for (const double roughness : {1.0, 0.5, 0.2}) {
    const Phong phong = phong_of(Color(1.0), 0.0, roughness);
    for (const double degrees : {0.0, 45.0, 80.0}) {
      const double angle = degrees * kPi / 180.0;
      const Vec3 to_light(std::sin(angle), 0.0, std::cos(angle));
      double sum = 0.0;
      constexpr int kSteps = 400;
      for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {  // uniform in the projected disc's area
          const double r = std::sqrt((i + 0.5) / kSteps), phi = 2.0 * kPi * (j + 0.5) / kSteps;
          const Vec3 out(r * std::cos(phi), r * std::sin(phi), std::sqrt(1.0 - r * r));
          sum += reflected(phong, {0.0, 0.0, 1.0}, to_light, out).r;
        }
      }
      const double reflectance = kPi * sum / (kSteps * kSteps) / to_light.z;
      EXPECT_LE(reflectance, 1.0 + 1e-3) << roughness << " " << degrees;
    }
  }
}

}  // namespace
}  // namespace amalgam::reference
