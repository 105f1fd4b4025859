// Shadows of many lights where an object stands on a wide table: each light has few texels there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "support/scene_builders.h"
#include "trace/shade.h"
#include "unit/passes/raster_rig.h"

namespace amalgam::passes {
namespace {

using namespace test_support;

constexpr double kHalf = 0.02, kHeight = 0.04;  // of a cube around the y axis, metres

// On the unit hemisphere, evenly (a spiral with the golden angle), all equally strong.
std::vector<scene::Light> hemisphere(int count) {
  std::vector<scene::Light> lights;
  for (int i = 0; i < count; ++i) {
    const double y = (i + 0.5) / count, r = std::sqrt(1.0 - y * y);
    const double angle = std::numbers::pi * (3.0 - std::sqrt(5.0)) * i;
    lights.push_back(make_sun(glm::vec3(r * std::cos(angle), y, r * std::sin(angle)),
                              glm::vec3(3.0f / static_cast<float>(count))));
  }
  return lights;
}

// Whether the way from a point of the table leads through the cube.
bool is_shadowed(const glm::dvec3& p, const glm::dvec3& to_light) {
  double enters = 0.0, leaves = kHeight / to_light.y;
  for (const int axis : {0, 2}) {
    const double a = (-kHalf - p[axis]) / to_light[axis], b = (kHalf - p[axis]) / to_light[axis];
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  return enters < leaves;
}

struct Irradiated {
  float mixed = 0.0f, real = 0.0f;
};

Irradiated expected_at(const glm::dvec3& p, const glm::dvec3& eye,
                       const std::vector<scene::Light>& lights, const scene::Material& material) {
  trace::SurfacePoint point;
  point.position = p;
  point.geometric_normal = point.shading_normal = glm::dvec3(0.0, 1.0, 0.0);
  const scene::PhongTerms terms = scene::phong_terms(material, glm::vec3(material.base_color));
  const glm::vec3 view(glm::normalize(eye - p));
  Irradiated sum;
  for (const scene::Light& light : lights) {
    const float one =
        trace::phong_contribution(terms, point, view, light.to_light, light.intensity).x;
    sum.real += one;
    if (!is_shadowed(p, glm::dvec3(light.to_light))) sum.mixed += one;
  }
  return sum;
}

struct Errors {
  double mean = 0.0;  // shares of the light without the cube
  double worst = 0.0;
  double at_foot = 0.0;  // the worst within a millimetre of the cube
  int pixels = 0, pixels_at_foot = 0;
};

// Of the table's pixels, within 25 mm of the cube.
Errors errors_under(int light_count) {
  const scene::Material material = make_diffuse(glm::vec3(0.5f));
  scene::Scene scene;
  add_object(scene, make_floor(0.0f, 0.6f), material, scene::Role::Real);
  const auto half = static_cast<float>(kHalf);
  add_object(scene, make_box({-half, 0.0f, -half}, {half, static_cast<float>(kHeight), half}),
             material, scene::Role::Virtual);
  const std::vector<scene::Light> lights = hemisphere(light_count);
  const common::CameraModel camera = make_pinhole(160, 120, 220.0);
  const glm::dvec3 eye(0.06, 0.12, 0.1);
  const glm::dmat4 camera_from_world = look_at(eye, {0.0, 0.005, 0.0});
  RasterRig rig(scene);
  const RasterFrame frame = rig.render(make_view(scene, camera, camera_from_world, lights));
  const glm::dmat3 world_from_camera = glm::transpose(glm::dmat3(camera_from_world));

  Errors errors;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const glm::vec4 mixed = frame.mixed->at(x, y);
      if (mixed.w != 0.0f) continue;  // the cube
      const glm::dvec3 direction = world_from_camera * glm::dvec3((x - camera.cx) / camera.fx,
                                                                  (y - camera.cy) / camera.fy, 1.0);
      const glm::dvec3 p = eye - eye.y / direction.y * direction;
      const double away = std::max(std::abs(p.x), std::abs(p.z)) - kHalf;
      if (away > 0.025) continue;
      const Irradiated expected = expected_at(p, eye, lights, material);
      EXPECT_NEAR(frame.real->at(x, y).x, expected.real, 1e-4f * expected.real);
      const double error =
          std::abs(static_cast<double>(mixed.x - expected.mixed)) / double{expected.real};
      errors.mean += error;
      errors.worst = std::max(errors.worst, error);
      ++errors.pixels;
      if (away > 0.001) continue;
      errors.at_foot = std::max(errors.at_foot, error);
      ++errors.pixels_at_foot;
    }
  }
  errors.mean /= errors.pixels;
  return errors;
}

// A light's edge may lie anywhere within a texel, and many lights average that out. Maps of the
// whole table, and look-ups that are moved off it, shift all edges the same way: then the mean was
// 0.006 to 0.018, and the worst at the foot 0.13 to 0.21.
TEST(Contact, IsLitByTheLightsThatReachIt) {
  struct Limits {
    int lights;
    double mean, at_foot, worst;
  };
  for (const Limits& limits : {Limits{8, 0.0004, 0.05, 0.25}, Limits{64, 0.0012, 0.1, 0.1},
                               Limits{256, 0.002, 0.1, 0.1}}) {
    const Errors errors = errors_under(limits.lights);
    EXPECT_GT(errors.pixels, 2000);
    EXPECT_GT(errors.pixels_at_foot, 50);
    EXPECT_LE(errors.mean, limits.mean) << limits.lights << " lights";
    EXPECT_LE(errors.at_foot, limits.at_foot) << limits.lights << " lights";
    EXPECT_LE(errors.worst, limits.worst) << limits.lights << " lights";
  }
}

}  // namespace
}  // namespace amalgam::passes
