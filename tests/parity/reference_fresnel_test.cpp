// Numerics B3 and B4: reflectance and direction at one surface.
#include <gtest/gtest.h>

#include <cmath>

#include "support/reference/fresnel.h"

namespace amalgam::reference {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kGlass = 1.5;

TEST(ReferenceFresnel, ExactTable) {
  const struct {
    double degrees, reflectance;
  } table[] = {{0.0, 0.04},      {45.0, 0.05024},  {60.0, 0.089187},
               {75.0, 0.253061}, {85.0, 0.612800}, {89.0, 0.904185}};
  for (const auto& [degrees, expected] : table) {
    // The table is rounded to its last digit.
    EXPECT_NEAR(exact_reflectance(1.0, kGlass, std::cos(degrees * kDegree)), expected, 6e-7)
        << degrees;
  }
}

TEST(ReferenceFresnel, ExactByTheAnglesForm) {
  // Fresnel's sine and tangent laws, which hold no index of refraction.
  for (double degrees = 0.5; degrees < 90.0; degrees += 0.5) {
    const double i = degrees * kDegree, t = std::asin(std::sin(i) / kGlass);
    const double s = std::sin(i - t) / std::sin(i + t), p = std::tan(i - t) / std::tan(i + t);
    EXPECT_NEAR(exact_reflectance(1.0, kGlass, std::cos(i)), 0.5 * (s * s + p * p), 1e-12);
  }
}

TEST(ReferenceFresnel, IsTheSameFromBothSides) {
  for (double degrees = 0.0; degrees < 90.0; degrees += 0.5) {
    const double outside = std::cos(degrees * kDegree);
    const auto inside = transmitted_cosine(1.0, kGlass, outside);
    ASSERT_TRUE(inside);
    for (const Fresnel model : {Fresnel::Schlick, Fresnel::Exact}) {
      EXPECT_NEAR(reflectance(model, 1.0, kGlass, outside),
                  reflectance(model, kGlass, 1.0, *inside), 1e-12)
          << degrees;
    }
  }
}

TEST(ReferenceFresnel, SchlicksGreatestError) {
  double greatest = 0.0, at = 0.0;
  for (double degrees = 0.0; degrees < 90.0; degrees += 0.01) {
    const double cosine = std::cos(degrees * kDegree);
    const double error = std::abs(reflectance(Fresnel::Schlick, 1.0, kGlass, cosine) -
                                  reflectance(Fresnel::Exact, 1.0, kGlass, cosine));
    if (error > greatest) {
      greatest = error;
      at = degrees;
    }
  }
  EXPECT_NEAR(greatest, 0.0357, 5e-5);
  EXPECT_NEAR(at, 85.0, 0.2);
}

TEST(ReferenceFresnel, EqualMediaHaveNoInterface) {
  for (const Fresnel model : {Fresnel::Schlick, Fresnel::Exact}) {
    for (const double cosine : {1.0, 0.5, 0.01}) {
      EXPECT_EQ(reflectance(model, kGlass, kGlass, cosine), 0.0);
    }
  }
}

TEST(ReferenceFresnel, CriticalAngle) {
  const double critical = std::asin(1.0 / kGlass);
  for (double away = 1e-1; away > 5e-8; away *= 0.1) {
    EXPECT_FALSE(transmitted_cosine(kGlass, 1.0, std::cos(critical + away)));
    EXPECT_EQ(reflectance(Fresnel::Schlick, kGlass, 1.0, std::cos(critical + away)), 1.0);
    EXPECT_EQ(reflectance(Fresnel::Exact, kGlass, 1.0, std::cos(critical + away)), 1.0);

    const Vec3 direction(std::sin(critical - away), -std::cos(critical - away), 0.0);
    const auto refracted = refract(direction, {0.0, 1.0, 0.0}, kGlass, 1.0);
    ASSERT_TRUE(refracted);
    // Snell: the tangential part grows by the ratio of the indices.
    EXPECT_NEAR(refracted->x, kGlass * direction.x, 1e-12);
    EXPECT_LT(refracted->y, 0.0);
    EXPECT_NEAR(glm::length(*refracted), 1.0, 1e-12);
  }
}

TEST(ReferenceFresnel, ThinSheetSumsItsInnerBounces) {
  for (const double r : {0.0, 0.04, 0.5, 0.9}) {
    double sum = r;
    for (int bounces = 0; bounces < 2000; ++bounces) {
      sum += (1.0 - r) * (1.0 - r) * std::pow(r, 2 * bounces + 1);
    }
    EXPECT_NEAR(thin_reflectance(r), sum, 1e-12);
  }
}

}  // namespace
}  // namespace amalgam::reference
