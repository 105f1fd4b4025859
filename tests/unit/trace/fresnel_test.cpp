#include "trace/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace amalgam::trace {
namespace {

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

// numerics B3: values of the Fresnel equations for n = 1.5 from outside.
TEST(Fresnel, ExactMatchesTheTable) {
  const std::pair<double, double> table[] = {{0, 0.04},      {45, 0.05024},  {60, 0.089187},
                                             {75, 0.253061}, {85, 0.612800}, {89, 0.904185}};
  for (const auto& [degrees, expected] : table) {
    EXPECT_NEAR(reflectance_exact(std::cos(radians(degrees)), 1.0, 1.5), expected, 1e-6) << degrees;
  }
}

TEST(Fresnel, ExactIsReciprocal) {
  for (double degrees = 0; degrees < 90; degrees += 0.5) {
    const double sin_t = std::sin(radians(degrees)) / 1.5;
    const double inside = reflectance_exact(std::sqrt(1 - sin_t * sin_t), 1.5, 1.0);
    EXPECT_NEAR(inside, reflectance_exact(std::cos(radians(degrees)), 1.0, 1.5), 1e-9) << degrees;
  }
}

// B3: Schlick is at most 0.0357 from the exact value for n = 1.5, inside too because the less dense
// side's cosine is used; with the inside cosine the error would be 0.959.
TEST(Fresnel, SchlickIsNearExactOnBothSides) {
  double worst_outside = 0, worst_inside = 0;
  for (double degrees = 0; degrees <= 90; degrees += 0.01) {
    const double c = std::cos(radians(degrees));
    worst_outside = std::max(
        worst_outside, std::abs(reflectance_schlick(c, 1.0, 1.5) - reflectance_exact(c, 1.0, 1.5)));
    worst_inside = std::max(
        worst_inside, std::abs(reflectance_schlick(c, 1.5, 1.0) - reflectance_exact(c, 1.5, 1.0)));
  }
  EXPECT_NEAR(worst_outside, 0.0357, 1e-4);
  EXPECT_NEAR(worst_inside, 0.0357, 1e-3);
}

// Where a liquid's mesh reaches into its glass, rays pass surfaces between equal media.
TEST(Fresnel, NothingReflectsBetweenEqualMedia) {
  for (const double degrees : {0.0, 45.0, 80.0, 89.9}) {
    const double c = std::cos(radians(degrees));
    EXPECT_EQ(reflectance_schlick(c, 1.5, 1.5), 0.0) << degrees;
    EXPECT_LT(reflectance_exact(c, 1.5, 1.5), 1e-20) << degrees;
  }
}

// B4: around the critical angle the decision is right and the direction stays accurate.
TEST(Fresnel, CriticalAngleIsDecidedRight) {
  const double critical = std::asin(1.0 / 1.5);
  const glm::dvec3 normal(0, 1, 0);
  for (double offset = 1e-1; offset > 0.9e-7; offset /= 10) {
    for (const double sign : {-1.0, 1.0}) {
      const double angle = critical + sign * offset;
      const glm::dvec3 direction(std::sin(angle), -std::cos(angle), 0);
      const auto refracted = refract(direction, normal, 1.5, 1.0);
      ASSERT_EQ(refracted.has_value(), sign < 0) << offset;
      EXPECT_EQ(reflectance_schlick(std::cos(angle), 1.5, 1.0) == 1.0, sign > 0) << offset;
      if (!refracted) continue;
      const double expected = std::asin(1.5 * std::sin(angle));
      EXPECT_NEAR(std::atan2(refracted->x, -refracted->y), expected, 1e-6) << offset;
    }
  }
}

// B5: a slab of thickness 1 shifts a ray at 45 degrees by 0.329142.
TEST(Refract, SlabShiftsARay) {
  const glm::dvec3 down = glm::normalize(glm::dvec3(1, -1, 0));
  const auto inside = refract(down, {0, 1, 0}, 1.0, 1.5);
  ASSERT_TRUE(inside);
  const double travelled = 1.0 / -inside->y;
  const glm::dvec3 leaves = travelled * *inside;
  const auto out = refract(*inside, {0, 1, 0}, 1.5, 1.0);
  ASSERT_TRUE(out);
  EXPECT_NEAR(glm::length(*out - down), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(leaves - glm::dot(leaves, down) * down), 0.329142, 1e-6);
}

// B6: where a ray parallel to the axis at height h crosses it behind a ball of radius 1, n = 1.5.
TEST(Refract, BallLensFocuses) {
  const std::pair<double, double> table[] = {{0.01, 1.49996}, {0.1, 1.49583}, {0.3, 1.46198}};
  for (const auto& [h, expected] : table) {
    const glm::dvec3 axis(1, 0, 0);
    const glm::dvec3 enter(-std::sqrt(1 - h * h), h, 0);
    const auto inside = refract(axis, enter, 1.0, 1.5);
    ASSERT_TRUE(inside);
    const glm::dvec3 leave = enter - 2.0 * glm::dot(enter, *inside) * *inside;
    const auto out = refract(*inside, -leave, 1.5, 1.0);
    ASSERT_TRUE(out);
    EXPECT_NEAR(leave.x - leave.y * out->x / out->y, expected, 1e-5) << h;
  }
}

TEST(Reflectance, OfAThinSheetSumsAllBounces) {
  const double r = reflectance_exact(1.0, 1.0, 1.5);
  EXPECT_NEAR(1.0 - thin_sheet_reflectance(r), 0.923077, 1e-6);
  EXPECT_NEAR(shadow_transmittance(1.0f, 1.5f, false), 0.96f, 1e-6f);
  EXPECT_NEAR(shadow_transmittance(1.0f, 1.5f, true), 0.923077f, 1e-6f);
}

TEST(Reflectance, OfAConductorIsItsColorHeadOnAndWhiteAtGrazing) {
  const glm::vec3 gold(1.0f, 0.77f, 0.34f);
  EXPECT_EQ(reflectance_conductor(gold, 1.0f), gold);
  EXPECT_NEAR(reflectance_conductor(gold, 0.0f).z, 1.0f, 1e-6f);
}

}  // namespace
}  // namespace amalgam::trace
