// Numerics B7, B8 and B10: series of mirrors, their truncation, and normals that point too far.
#include <gtest/gtest.h>

#include <cmath>

#include "parity/closed_form_rig.h"
#include "support/reference/bent_normal.h"

namespace amalgam::reference {
namespace {

using test_support::make_mirror;
using test_support::make_quad;

// Two mirrors of reflectance r that glow with radiance e and face each other along z; the ray
// starts between them.
ClosedFormRig facing_mirrors(float r, float e) {
  ClosedFormRig rig;
  scene::Material mirror = make_mirror(glm::vec3(r));
  mirror.emission = glm::vec3(e);
  rig.add(make_quad({0.0f, 0.0f, -1.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}), mirror);
  rig.add(make_quad({0.0f, 0.0f, 1.0f}, {-1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}), mirror);
  return rig;
}

const Vec3 kStart(0.1, 0.23, 0.0);
const Vec3 kForward(0.0, 0.0, -1.0);

TEST(ReferenceMirror, FacingMirrorsSumTheGeometricSeries) {
  const struct {
    float r;
    int depth_for_a_byte;  // numerics B7: truncation below 1/255
  } table[] = {{0.5f, 8}, {0.8f, 25}, {0.9f, 53}, {0.95f, 109}, {0.99f, 552}};
  for (const auto& [ratio, depth_for_a_byte] : table) {
    const double r = static_cast<double>(ratio);
    EXPECT_EQ(std::lround(std::ceil(std::log(1.0 / 255.0) / std::log(r))), depth_for_a_byte);
    ClosedFormRig rig = facing_mirrors(ratio, 0.25f);
    for (const int depth : {0, 1, 5, depth_for_a_byte}) {
      rig.settings.max_depth = depth;
      const double expected = 0.25 * (1.0 - std::pow(r, depth + 1)) / (1.0 - r);
      EXPECT_NEAR(rig.trace(kStart, kForward).mixed.r, expected, 1e-9 * expected);
    }
  }
}

TEST(ReferenceMirror, ImportanceCutoffStaysBelowItsBound) {
  for (const double cutoff : {0.1, 0.01, 0.001}) {
    ClosedFormRig rig = facing_mirrors(0.9f, 1.0f);
    rig.settings = {.max_depth = 1000, .importance_cutoff = cutoff, .fresnel = Fresnel::Schlick};
    const double r = static_cast<double>(0.9f);
    const double bias = 1.0 / (1.0 - r) - rig.trace(kStart, kForward).mixed.r;
    EXPECT_GT(bias, 0.0);
    EXPECT_LE(bias, cutoff / (1.0 - r));
  }
}

TEST(ReferenceMirror, ReflectsBySchlickWithItsColor) {
  ClosedFormRig rig;
  rig.add(make_quad(glm::vec3(0.0f), {9.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -9.0f}),
          make_mirror({1.0f, 0.5f, 0.25f}));
  rig.set_environment(glm::vec3(2.0f));
  for (const double degrees : {0.0, 30.0, 60.0, 85.0}) {
    const double angle = degrees * kPi / 180.0;
    const Sample sample = rig.trace({-std::sin(angle), std::cos(angle), 0.23},
                                    {std::sin(angle), -std::cos(angle), 0});
    const Color f0(1.0, 0.5, 0.25);
    const Color expected = 2.0 * (f0 + (1.0 - f0) * std::pow(1.0 - std::cos(angle), 5.0));
    EXPECT_LT(glm::length(sample.mixed - expected), 1e-12);
    EXPECT_TRUE(sample.met_virtual);
    EXPECT_TRUE(sample.specular_first);
  }
}

TEST(ReferenceMirror, RealMirrorIsMarkedVirtualOnlyByWhatItShows) {
  ClosedFormRig rig;
  rig.add(make_quad(glm::vec3(0.0f), {9.0f, 0.0f, 0.0f}, {0.0f, 9.0f, 0.0f}), make_mirror(),
          scene::Role::Real);
  rig.add(make_quad({0.0f, 0.0f, 8.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, -1.0f, 0.0f}), make_lamp());
  EXPECT_TRUE(rig.trace(Vec3(0.1, 0.23, 5.0), kForward).met_virtual);
  EXPECT_FALSE(rig.trace(Vec3(5.0, 0.23, 5.0), kForward).met_virtual);
  EXPECT_TRUE(rig.trace(Vec3(5.0, 0.23, 5.0), kForward).specular_first);
}

TEST(ReferenceMirror, BentNormalsReflectUpwards) {
  const Vec3 geometric(0.0, 0.0, 1.0);
  int bent = 0;
  for (int i = 0; i < 2000; ++i) {
    const double view_angle = 0.5 * kPi * (i % 40 + 0.5) / 40.0;
    const Vec3 to_viewer(std::sin(view_angle), 0.0, std::cos(view_angle));
    const double tilt = 0.4 * kPi * (i % 7) / 7.0, around = 0.37 * i;
    const Vec3 shading(std::sin(tilt) * std::cos(around), std::sin(tilt) * std::sin(around),
                       std::cos(tilt));
    const Vec3 normal = bend_normal(shading, geometric, to_viewer);
    const Vec3 reflected_direction = reflect(-to_viewer, normal);
    EXPECT_GT(glm::dot(reflected_direction, geometric), 0.0);
    EXPECT_GT(glm::dot(normal, to_viewer), 0.0);
    bent += normal == shading ? 0 : 1;
  }
  EXPECT_GT(bent, 100);
  EXPECT_LT(bent, 1900);
}

}  // namespace
}  // namespace amalgam::reference
