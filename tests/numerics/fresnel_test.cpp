// numerics B3, B4 and B6: Fresnel's equations and Snell's law towards grazing and critical angles,
// and over all indices.
#include "trace/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace amalgam::trace {
namespace {

// Head on: ((n - 1) / (n + 1))^2, from air to whatever there is.
TEST(FresnelRange, HeadOnReflectanceOverAllIndices) {
  for (int exponent = -12; exponent <= 150; ++exponent) {
    const double n = 1.0 + std::pow(10.0, exponent);
    const double expected = std::pow((n - 1.0) / (n + 1.0), 2.0);
    EXPECT_NEAR(reflectance_exact(1.0, 1.0, n), expected, 1e-15 + 1e-12 * expected) << n;
    EXPECT_NEAR(reflectance_schlick(1.0, 1.0, n), expected, 1e-15 + 1e-12 * expected) << n;
  }
  // Beyond: (n - 1)^2 is no longer a double, but the limit is still right.
  EXPECT_FALSE(std::isfinite(std::pow(1e200, 2.0)));
  EXPECT_NEAR(reflectance_exact(1.0, 1.0, 1e200), 1.0, 1e-12);
}

// 1 - R is 4 (n + 1/n... ) cos near grazing: the part that is transmitted goes to 0 with the
// cosine, and from inside and from outside it is the same.
TEST(FresnelRange, ReciprocalAlmostUpToGrazing) {
  const auto difference = [](double cosine) {
    const double sin_t = std::sqrt(1.0 - cosine * cosine) / 1.5;
    const double inside = std::sqrt(1.0 - sin_t * sin_t);
    const double out = 1.0 - reflectance_exact(cosine, 1.0, 1.5);
    const double in = 1.0 - reflectance_exact(inside, 1.5, 1.0);
    return std::abs(in / out - 1.0);
  };
  for (double cosine = 1.0; cosine > 0.9e-4; cosine /= 10.0) {
    EXPECT_LT(difference(cosine), 1e-6) << cosine;
  }
  // Beyond: the cosine inside differs from the critical angle's in the last digits alone. The
  // reflectance itself stays right, because almost nothing is transmitted.
  EXPECT_GT(difference(1e-8), 1e-3);
  EXPECT_NEAR(reflectance_exact(1e-8, 1.0, 1.5), 1.0, 1e-7);
}

// From inside glass, this many radians beside the critical angle.
std::optional<glm::dvec3> refracted_beside_critical(double offset) {
  const double angle = std::asin(1.0 / 1.5) + offset;
  return refract({std::sin(angle), -std::cos(angle), 0}, {0, 1, 0}, 1.5, 1.0);
}

TEST(FresnelRange, TheCriticalAngleIsToldToFifteenDigits) {
  for (double offset = 1e-1; offset > 0.9e-14; offset /= 10.0) {
    EXPECT_FALSE(refracted_beside_critical(offset)) << offset;
    const auto refracted = refracted_beside_critical(-offset);
    ASSERT_TRUE(refracted) << offset;
    const double angle = std::asin(1.0 / 1.5) - offset;
    const double expected = std::atan2(
        1.5 * std::sin(angle), std::sqrt(std::max(0.0, 1.0 - std::pow(1.5 * std::sin(angle), 2))));
    EXPECT_NEAR(std::atan2(refracted->x, -refracted->y), expected, 1e-4) << offset;
    EXPECT_NEAR(glm::length(*refracted), 1.0, 1e-12);
  }
  // Beyond: a double's last digit decides; there is either no ray or a unit one along the surface.
  for (double offset = 1e-15; offset > 1e-20; offset /= 10.0) {
    for (const double side : {offset, -offset}) {
      if (const auto refracted = refracted_beside_critical(side)) {
        EXPECT_NEAR(refracted->x, 1.0, 1e-12);
        EXPECT_NEAR(glm::length(*refracted), 1.0, 1e-12);
      }
    }
  }
}

// A ray at height h parallel to the axis of a ball of radius 1 and index 1.5 is bent by
// 2 (asin h - asin(h / n)), and crosses the axis at h / sin(that).
TEST(FresnelRange, ABallLensFocusesFromItsAxisToItsRim) {
  constexpr double kIndex = 1.5;
  const auto crossing = [](double h) {
    const glm::dvec3 enter(-std::sqrt(1.0 - h * h), h, 0);
    const auto inside = refract({1, 0, 0}, enter, 1.0, kIndex);
    const glm::dvec3 leave = enter - 2.0 * glm::dot(enter, *inside) * *inside;
    const auto out = refract(*inside, -leave, kIndex, 1.0).value();
    return leave.x - leave.y * out.x / out.y;
  };
  for (const double h :
       {1e-300, 1e-13, 1e-7, 1e-4, 1e-2, 0.3, 0.9, 0.999, 1.0 - 1e-9, 1.0 - 1e-15}) {
    const double bent = 2.0 * (std::asin(h) - std::asin(h / kIndex));
    EXPECT_NEAR(crossing(h), h / std::sin(bent), 1e-7) << h;
  }
}

}  // namespace
}  // namespace amalgam::trace
