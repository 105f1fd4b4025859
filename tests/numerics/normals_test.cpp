// numerics B10: smooth normals on coarse triangles lean so far that a ray could be reflected into
// the surface, or refracted out of it. Spheres from 20 to 20,480 triangles, from all sides.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "numerics/icosphere.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;
using test_support::make_icosphere;

constexpr int kMostSubdivisions = 5;

TraceResult trace_ball(int subdivisions, scene::Material material, const glm::dvec3& eye,
                       int depth) {
  const scene::Environment furnace = constant_environment(1.0f);
  scene::Scene scene;
  add_object(scene, make_icosphere(subdivisions), std::move(material), scene::Role::Virtual);
  return trace_shot(scene, {.eye = eye,
                            .settings = {.max_depth = depth, .importance_cutoff = 0.0f},
                            .environment = &furnace,
                            .width = 48,
                            .height = 48,
                            .focal_length = 60,
                            .keep_provenance = true});
}

std::vector<glm::dvec3> eyes() {
  std::mt19937 random(10);
  std::normal_distribution<double> normal;
  std::vector<glm::dvec3> eyes;
  for (int i = 0; i < 6; ++i) {
    eyes.push_back(3.0 *
                   glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))));
  }
  return eyes;
}

TEST(ShadingNormals, AConvexMirrorReflectsEachRayOnce) {
  for (int subdivisions = 0; subdivisions <= kMostSubdivisions; ++subdivisions) {
    for (const glm::dvec3& eye : eyes()) {
      const TraceResult result = trace_ball(subdivisions, test_support::make_mirror(), eye, 10);
      EXPECT_GT(result.counts.primary_specular, 800u);
      EXPECT_EQ(result.counts.rays.reflection, result.counts.primary_specular)
          << "rays were reflected into a ball of " << (20 << 2 * subdivisions) << " triangles";
    }
  }
}

// The ray that glass refracts at its first surface must be inside, where it meets the ball again
// and, at this depth, is cut off. If it were outside, it would take the environment.
TEST(ShadingNormals, RefractedRaysGoIntoTheGlass) {
  for (int subdivisions = 0; subdivisions <= kMostSubdivisions; ++subdivisions) {
    for (const glm::dvec3& eye : eyes()) {
      const TraceResult result = trace_ball(subdivisions, test_support::make_glass(), eye, 1);
      int black = 0, leaks = 0;
      for (std::size_t i = 0; i < result.images->mixed.pixels().size(); ++i) {
        if (result.images->met_virtual.pixels()[i] == 0) continue;
        black += std::abs(result.images->mixed.pixels()[i].x - 1.0f) < 1e-5f ? 0 : 1;
        const core::Provenance& shares = result.provenance->pixels()[i];
        leaks += shares[static_cast<std::size_t>(core::LightSource::CutOff)] > 0.0f ? 0 : 1;
      }
      EXPECT_EQ(black, 0) << subdivisions;
      EXPECT_EQ(leaks, 0) << subdivisions;
    }
  }
}

// Single interactions with normals that lean by up to this angle: how many rays end on the wrong
// side of the surface.
struct WrongSides {
  int reflected = 0, entering = 0, leaving = 0;
  int bent = 0;  // would have left on the wrong side without valid_refraction()
};

WrongSides wrong_sides(double lean) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const auto direction = [&] {
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
  };
  WrongSides wrong;
  const glm::dvec3 up(0, 1, 0);
  for (int i = 0; i < 50000; ++i) {
    glm::dvec3 view = direction();
    view.y = std::abs(view.y) * std::pow(10.0, -3.0 * share(random));  // more of grazing ones
    view = glm::normalize(view);
    const double angle = lean * share(random);
    const glm::dvec3 beside = glm::normalize(glm::cross(up, direction()));
    const glm::dvec3 smooth =
        valid_shading_normal(up, std::cos(angle) * up + std::sin(angle) * beside, view);
    wrong.reflected += reflect(-view, smooth).y > 0.0 ? 0 : 1;
    if (const auto in = refract(-view, smooth, 1.0, 1.5)) {
      wrong.entering += valid_refraction(up, *in).y < 0.0 ? 0 : 1;
    }
    if (const auto out = refract(-view, smooth, 1.5, 1.0)) {
      wrong.leaving += valid_refraction(up, *out).y < 0.0 ? 0 : 1;
      wrong.bent += out->y < 0.0 ? 0 : 1;
    }
  }
  return wrong;
}

TEST(ShadingNormals, EveryRayEndsOnItsSideOfTheSurface) {
  for (const double degrees : {1.0, 10.0, 30.0, 60.0, 89.9}) {
    const WrongSides wrong = wrong_sides(degrees * std::numbers::pi / 180.0);
    EXPECT_EQ(wrong.reflected, 0) << degrees;
    EXPECT_EQ(wrong.entering, 0) << degrees;
    EXPECT_EQ(wrong.leaving, 0) << degrees;
    EXPECT_GT(wrong.bent, 0) << "the case does not occur at " << degrees;
  }
}

}  // namespace
}  // namespace amalgam::trace
