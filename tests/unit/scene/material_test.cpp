#include "scene/material.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace amalgam::scene {
namespace {

TEST(Material, NormalReflectanceOfGlassIsFourPercent) {
  EXPECT_FLOAT_EQ(normal_reflectance(1.5f), 0.04f);
  EXPECT_EQ(normal_reflectance(1.0f), 0.0f);
  EXPECT_NEAR(normal_reflectance(2.419f), 0.17225f, 1e-4f);
}

TEST(Material, ExponentGrowsAsRoughnessFalls) {
  Material material;
  float before = -1.0f;
  for (float roughness = 1.0f; roughness > 0.0f; roughness -= 0.05f) {
    material.roughness = roughness;
    const float exponent = phong_terms(material, glm::vec3(0.5f)).exponent;
    EXPECT_GE(exponent, before);
    EXPECT_GE(exponent, 0.0f);
    EXPECT_LE(exponent, 1024.0f);
    before = exponent;
  }
  material.roughness = 0.0f;
  EXPECT_EQ(phong_terms(material, glm::vec3(0.5f)).exponent, 1024.0f);
}

// The lobe of the width of a microfacet distribution of alpha = roughness^2: 1/2 alpha^-2 - 1/2.
TEST(Material, ExponentComesFromTheSquareOfTheRoughness) {
  Material material;
  for (const auto& [roughness, exponent] : {std::pair(1.0f, 0.0f), {0.5f, 7.5f}, {0.25f, 127.5f}}) {
    material.roughness = roughness;
    EXPECT_FLOAT_EQ(phong_terms(material, glm::vec3(0.5f)).exponent, exponent);
  }
}

// At normal incidence the lobe integrates to specular (exponent + 2) / (exponent + 2) = specular,
// so the sum must not exceed 1 (Lafortune and Willems 1994).
TEST(Material, ReflectsNoMoreThanItReceives) {
  for (const float metallic : {0.0f, 0.3f, 1.0f}) {
    Material material;
    material.metallic = metallic;
    const PhongTerms terms = phong_terms(material, glm::vec3(1.0f));
    EXPECT_LE(terms.albedo.x + terms.specular.x, 1.0f + 1e-6f) << metallic;
  }
}

TEST(Material, MetalsHaveNoAlbedo) {
  Material material;
  material.metallic = 1.0f;
  const PhongTerms terms = phong_terms(material, {1.0f, 0.7f, 0.3f});
  EXPECT_EQ(terms.albedo, glm::vec3(0.0f));
  EXPECT_EQ(terms.specular, glm::vec3(1.0f, 0.7f, 0.3f));
}

}  // namespace
}  // namespace amalgam::scene
