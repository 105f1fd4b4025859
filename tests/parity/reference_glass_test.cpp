// Numerics B5, B6, B9 and absorption: rays through glass against their closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "parity/closed_form_rig.h"

namespace amalgam::reference {
namespace {

using test_support::make_box;
using test_support::make_glass;
using test_support::make_quad;
using test_support::make_sphere;

constexpr double kR = 0.04;         // of n = 1.5 at normal incidence
const Vec3 kStart(0.1, 0.23, 5.0);  // off the faces' diagonals
const Vec3 kForward(0.0, 0.0, -1.0);

// A slab from z = 0 to -1 in front of a lamp at z = -3. Outside it is dark.
ClosedFormRig slab(const scene::Material& glass) {
  ClosedFormRig rig;
  rig.add(make_box({-9.0f, -9.0f, -1.0f}, {9.0f, 9.0f, 0.0f}), glass);
  rig.add(make_quad({0.0f, 0.0f, -3.0f}, {9.0f, 0.0f, 0.0f}, {0.0f, 9.0f, 0.0f}), make_lamp());
  return rig;
}

TEST(ReferenceGlass, SlabTransmitsTheGeometricSeries) {
  ClosedFormRig rig = slab(make_glass(1.5f));
  // Depth 2 reaches the lamp straight, every two more add an inner bounce.
  double partial = 0.0;
  for (int bounces = 0; bounces < 4; ++bounces) {
    partial += (1.0 - kR) * (1.0 - kR) * std::pow(kR, 2 * bounces);
    for (const int idle : {0, 1}) {
      rig.settings.max_depth = 2 + 2 * bounces + idle;
      EXPECT_NEAR(rig.trace(kStart, kForward).mixed.r, partial, 1e-14);
    }
  }
  rig.settings.max_depth = 40;
  EXPECT_NEAR(rig.trace(kStart, kForward).mixed.r, (1.0 - kR) / (1.0 + kR), 1e-14);
  EXPECT_NEAR((1.0 - kR) / (1.0 + kR), 0.923077, 5e-7);
}

TEST(ReferenceGlass, SlabAtAnAngleByBothModels) {
  for (const Fresnel model : {Fresnel::Schlick, Fresnel::Exact}) {
    for (const double degrees : {10.0, 45.0, 80.0}) {
      ClosedFormRig rig = slab(make_glass(1.5f));
      rig.settings.fresnel = model;
      rig.settings.max_depth = 60;
      // Wide enough that every inner bounce leaves towards the lamp.
      rig.scene.instances[0].anchor_from_mesh[0][0] = 1000.0f;
      rig.scene.instances[1].anchor_from_mesh[0][0] = 1000.0f;
      const double angle = degrees * kPi / 180.0;
      const Vec3 direction(std::sin(angle), 0.0, -std::cos(angle));
      const double r = reflectance(model, 1.0, 1.5, std::cos(angle));
      EXPECT_NEAR(rig.trace({0.1, 0.23, 1.0}, direction).mixed.r, (1.0 - r) / (1.0 + r), 1e-9)
          << degrees;
    }
  }
}

TEST(ReferenceGlass, AbsorbingSlab) {
  const glm::vec3 sigma(0.5f, 1.0f, 2.0f);
  ClosedFormRig rig = slab(make_glass(1.5f, sigma));
  rig.settings.max_depth = 60;
  const Sample sample = rig.trace(kStart, kForward);
  for (glm::length_t c = 0; c < 3; ++c) {
    const double a = std::exp(-static_cast<double>(sigma[c]));  // thickness 1
    EXPECT_NEAR(sample.mixed[c], (1.0 - kR) * (1.0 - kR) * a / (1.0 - kR * kR * a * a), 1e-14);
  }
}

TEST(ReferenceGlass, ThinSheetTransmitsLikeASlab) {
  ClosedFormRig rig;
  scene::Material sheet = make_glass(1.5f, glm::vec3(3.0f));  // thin: absorbs nothing
  sheet.thin = true;
  rig.add(make_quad({0.0f, 0.0f, 0.0f}, {9.0f, 0.0f, 0.0f}, {0.0f, 9.0f, 0.0f}), sheet);
  rig.add(make_quad({0.0f, 0.0f, -3.0f}, {9.0f, 0.0f, 0.0f}, {0.0f, 9.0f, 0.0f}), make_lamp());
  EXPECT_NEAR(rig.trace(kStart, kForward).mixed.r, (1.0 - kR) / (1.0 + kR), 1e-14);
}

TEST(ReferenceGlass, ColoredGlassTintsAtEverySurface) {
  scene::Material glass = make_glass(1.5f);
  glass.base_color = {0.25f, 0.5f, 1.0f, 1.0f};
  ClosedFormRig rig = slab(glass);
  rig.settings.max_depth = 2;
  const Sample sample = rig.trace(kStart, kForward);
  const Color tint(0.25, 0.5, 1.0);
  EXPECT_LT(glm::length(sample.mixed - (1.0 - kR) * (1.0 - kR) * tint * tint), 1e-14);
}

// L / n^2 is conserved: the floor lies in the glass, and its light spreads on the way out.
TEST(ReferenceGlass, FloorUnderADielectricPlane) {
  ClosedFormRig rig;
  rig.add(make_box({-9.0f, -9.0f, -3.0f}, {9.0f, 9.0f, 0.0f}), make_glass(1.5f));
  rig.add(make_quad({0.0f, 0.0f, -1.0f}, {8.0f, 0.0f, 0.0f}, {0.0f, 8.0f, 0.0f}),
          test_support::make_diffuse(glm::vec3(1.0f)));  // Lambertian
  rig.lights.push_back(test_support::make_sun({0.0f, 0.0f, 1.0f}));
  rig.settings.max_depth = 1;
  // A white floor gets back what the surface reflects inwards: 1 / (1 - R) in all.
  const double white = 2.25 / ((1.0 - kR) * 20.0 / 21.0);
  for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
    const double angle = degrees * kPi / 180.0;
    const Vec3 direction(std::sin(angle), 0.0, -std::cos(angle));
    const double gets_out = 1.0 - reflectance(Fresnel::Schlick, 1.0, 1.5, std::cos(angle));
    EXPECT_NEAR(rig.trace(Vec3(0.1, 0.23, 0.0) - direction, direction).mixed.r,
                white * 3.0 * (1.0 - kR) / kPi * gets_out / 2.25, 1e-7)
        << degrees;
  }
}

TEST(ReferenceGlass, AirBubbleInASlab) {
  ClosedFormRig rig = slab(make_glass(1.5f));
  rig.add(make_box({-1.0f, -1.0f, -0.75f}, {1.0f, 1.0f, -0.25f}), make_glass(1.0f));
  rig.settings.max_depth = 4;  // four surfaces, no inner bounce
  EXPECT_NEAR(rig.trace(kStart, kForward).mixed.r, std::pow(1.0 - kR, 4.0), 1e-14);
}

// Walks straight through: refraction at every surface, no reflections.
Ray walk(const World& world, Ray ray, int surfaces) {
  double n1 = 1.0;
  for (int i = 0; i < surfaces; ++i) {
    const auto hit = world.closest(ray);
    if (!hit) throw std::runtime_error("the walk left the glass");
    const bool entering = is_front(ray, *hit);
    const double n2 = entering ? static_cast<double>(world.object(*hit).material.ior) : 1.0;
    const Vec3 normal = entering ? hit->shading_normal : -hit->shading_normal;
    ray = ray_from_surface(hit->position, refract(ray.direction, normal, n1, n2).value());
    n1 = n2;
  }
  return ray;
}

TEST(ReferenceGlass, SlabShiftsARay) {
  const World world = slab(make_glass(1.5f)).world();
  const Vec3 direction = glm::normalize(Vec3(1.0, 0.0, -1.0));
  const Vec3 origin(-1.0, 0.23, 1.0);
  const Ray out = walk(world, {origin, direction}, 2);
  EXPECT_LT(glm::length(out.direction - direction), 1e-12);
  const Vec3 offset = out.origin - origin;
  const double shift = glm::length(offset - glm::dot(offset, direction) * direction);
  const double in = kPi / 4.0, inside = std::asin(std::sin(in) / 1.5);
  EXPECT_NEAR(shift, std::sin(in - inside) / std::cos(inside), 1e-12);
  EXPECT_NEAR(shift, 0.329142, 5e-7);
}

TEST(ReferenceGlass, BallLensCrossesTheAxis) {
  const struct {
    double height, crossing;
  } table[] = {{0.01, 1.49996}, {0.1, 1.49583}, {0.3, 1.46198}};
  ClosedFormRig rig;
  rig.add_ball(Vec3(0.0), 1.0, make_glass(1.5f));
  const World world = rig.world();
  for (const auto& [height, crossing] : table) {
    const Ray out = walk(world, {{0.0, height, 5.0}, kForward}, 2);
    const double z = out.at(-out.origin.y / out.direction.y).z;
    const double deviation = 2.0 * (std::asin(height) - std::asin(height / 1.5));
    EXPECT_NEAR(-z, height / std::sin(deviation), 1e-9);
    EXPECT_NEAR(-z, crossing, 1e-5);
  }
}

TEST(ReferenceGlass, FurnaceHoldsForAnyShapeAndDirection) {
  for (int shape = 0; shape < 4; ++shape) {
    ClosedFormRig rig;
    if (shape == 0) rig.add(make_box(glm::vec3(-1.0f), glm::vec3(1.0f)), make_glass(1.5f));
    if (shape == 1) rig.add(make_sphere(glm::vec3(0.0f), 1.0f, 12, 6), make_glass(1.5f));
    if (shape == 2) rig.add_ball(Vec3(0.0), 1.0, make_glass(2.4f));
    if (shape == 3) {
      rig.add_ball(Vec3(0.0), 1.0, make_glass(1.5f));
      rig.add_ball(Vec3(0.2, 0.0, 0.0), 0.5, make_glass(1.0f));
    }
    rig.set_environment(glm::vec3(1.0f));
    rig.settings.max_depth = 12;
    for (int i = 0; i < 400; ++i) {
      // Branches that end take the environment, so energy is conserved at any depth.
      const Vec3 target(1.1 * std::sin(1.7 * i), 1.1 * std::cos(2.3 * i), 0.0);
      const Vec3 origin(3.0 * std::sin(0.9 * i), 1.0, 3.0 * std::cos(0.9 * i));
      const Sample sample = rig.trace(origin, target - origin);
      if (!sample.met_virtual) continue;
      EXPECT_NEAR(sample.mixed.g, 1.0, 1e-12);
    }
  }
}

TEST(ReferenceGlass, RaysStartInTheMediaAround) {
  ClosedFormRig rig;
  rig.add(make_box(glm::vec3(-2.0f), glm::vec3(2.0f)), make_glass(1.33f));
  rig.add(make_sphere(glm::vec3(0.0f), 1.0f, 24, 12), make_glass(1.5f));
  rig.add(make_quad({0.0f, 0.0f, -5.0f}, {9.0f, 0.0f, 0.0f}, {0.0f, 9.0f, 0.0f}), make_glass(1.7f));
  rig.add_ball(Vec3(0.0, 0.0, 0.5), 0.25, make_glass(1.0f));
  const World world = rig.world();
  const auto indices = [&](const Vec3& point) {
    std::vector<float> result;
    for (MediaStack media = media_around(world, point); !media.empty();) {
      result.push_back(media.innermost()->material.ior);
      media = media.left(*media.innermost());
    }
    return result;
  };
  EXPECT_EQ(indices({0.1, 0.2, 3.0}), std::vector<float>{});
  EXPECT_EQ(indices({0.1, 0.2, -4.99}), std::vector<float>{});  // an open surface
  EXPECT_EQ(indices({0.1, 0.2, 1.5}), std::vector<float>{1.33f});
  EXPECT_EQ(indices({0.1, 0.2, -0.3}), (std::vector<float>{1.5f, 1.33f}));
  EXPECT_EQ(indices({0.1, 0.0, 0.5}), (std::vector<float>{1.0f, 1.5f, 1.33f}));
}

TEST(ReferenceGlass, CameraInWaterSeesOutThroughOneSurface) {
  ClosedFormRig rig = slab(make_glass(1.5f, {0.5f, 1.0f, 2.0f}));
  const Color seen = rig.trace({0.1, 0.23, -0.25}, kForward).mixed;
  // Straight on, and once to and fro: the way in glass is 0.75 m, then 2 m more.
  rig.settings.max_depth = 1;
  const Color straight = rig.trace({0.1, 0.23, -0.25}, kForward).mixed;
  const Color sigma(0.5, 1.0, 2.0);
  // In glass, the lamp outside has n^2 times its radiance.
  EXPECT_LT(glm::length(straight - 2.25 * (1.0 - kR) * glm::exp(-0.75 * sigma)), 1e-14);
  const Color series = 1.0 / (1.0 - kR * kR * glm::exp(-2.0 * sigma));
  EXPECT_LT(glm::length(seen - straight * series), 1e-9);
}

TEST(ReferenceGlass, LowDynamicRangeEnvironmentGoesToItsOwnImage) {
  ClosedFormRig rig;
  rig.add_ball(Vec3(0.0), 1.0, make_glass(1.5f));
  rig.set_environment({0.5f, 0.25f, 1.0f}, true);
  const Sample sample = rig.trace({0.1, 0.2, 5.0}, kForward);
  EXPECT_EQ(sample.mixed, Color(0.0));
  EXPECT_LT(glm::length(sample.environment_reflection - Color(0.5, 0.25, 1.0)), 1e-12);
}

}  // namespace
}  // namespace amalgam::reference
