// Flat layers of glass and liquid, in both usual modellings of a liquid in a vessel: it reaches a
// little into the glass, or a gap of air is left around it.
//
// The walls stand across z, the eye looks along -z from the front. All expected values are closed
// forms: Snell, Fresnel and Beer-Lambert for each layer.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "unit/trace/glass_meshes.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;
using test_support::make_box;
using test_support::make_glass;
using test_support::make_quad;

constexpr float kGlass = 1.5f, kWater = 1.33f;
constexpr float kStep = 1e-2f;  // how far the liquid reaches into the glass, or stays away from it
const glm::vec3 kGlassAbsorption(0.7f, 0.2f, 0.0f), kWaterAbsorption(0.1f, 0.9f, 0.0f);

struct Layer {
  double index, thickness;
  glm::vec3 absorption{0.0f};
};

struct Modelling {
  std::string name;
  float water_margin;         // how far the water reaches into the glass, metres; < 0: a gap
  std::vector<Layer> layers;  // as a ray along -z should meet them
};
void PrintTo(const Modelling& modelling, std::ostream* out) {
  *out << modelling.name;
}

// Walls of glass from z = 0.7 to 1 and from 0 to 0.2, with water between them.
scene::Scene vessel(float water_margin, bool absorbing = false) {
  const auto box = [](float low, float high, float half) {
    return make_box({-half, -half, low}, {half, half, high});
  };
  const float m = water_margin;
  scene::Scene scene;
  add_object(scene, box(0.0f, 1.0f, 8.0f),
             make_glass(kGlass, absorbing ? kGlassAbsorption : glm::vec3(0.0f)),
             scene::Role::Virtual);
  add_to_last_material(scene, turned_inside_out(box(0.2f, 0.7f, 7.0f)));
  add_object(scene, box(0.2f - m, 0.7f + m, 7.0f + m),
             make_glass(kWater, absorbing ? kWaterAbsorption : glm::vec3(0.0f)),
             scene::Role::Virtual);
  return scene;
}

// Where they overlap, the medium entered last counts: the water begins at its own surface and ends
// where the glass begins.
const Modelling kOverlapping{"Overlapping",
                             kStep,
                             {{kGlass, 0.3 - kStep, kGlassAbsorption},
                              {kWater, 0.5 + kStep, kWaterAbsorption},
                              {kGlass, 0.2, kGlassAbsorption}}};
const Modelling kWithGap{"WithGap",
                         -kStep,
                         {{kGlass, 0.3, kGlassAbsorption},
                          {1.0, kStep},
                          {kWater, 0.5 - 2.0 * kStep, kWaterAbsorption},
                          {1.0, kStep},
                          {kGlass, 0.2, kGlassAbsorption}}};

double sine_in(const Layer& layer, double angle) {
  return std::sin(angle) / layer.index;
}

// Reflectances of the interfaces from air through the layers to air.
std::vector<double> reflectances(FresnelModel model, const std::vector<Layer>& layers,
                                 double angle) {
  std::vector<double> result;
  Layer here{1.0, 0.0};
  std::vector<Layer> beyond = layers;
  beyond.push_back({1.0, 0.0});
  for (const Layer& next : beyond) {
    const double sine = sine_in(here, angle);
    result.push_back(reflectance(model, std::sqrt(1.0 - sine * sine), here.index, next.index));
    here = next;
  }
  return result;
}

double straight_transmittance(const std::vector<double>& reflectances) {
  double product = 1.0;
  for (const double r : reflectances) product *= 1.0 - r;
  return product;
}

// Infinite inner bounces between interfaces that absorb nothing: 1 / (1 + sum R / (1 - R)).
double total_transmittance(const std::vector<double>& reflectances) {
  double sum = 0.0;
  for (const double r : reflectances) sum += r / (1.0 - r);
  return 1.0 / (1.0 + sum);
}

// How far to the side a ray has come behind the layers.
double advance(const std::vector<Layer>& layers, double angle) {
  double x = 0.0;
  for (const Layer& layer : layers) {
    x += layer.thickness * std::tan(std::asin(sine_in(layer, angle)));
  }
  return x;
}

void add_lamp_behind(scene::Scene& scene) {
  add_object(scene, make_quad({0, 0, -0.5f}, {9, 0, 0}, {0, 9, 0}), emitter(1.0f),
             scene::Role::Virtual);
}

class Layers : public testing::TestWithParam<Modelling> {
 protected:
  scene::Scene scene_ = vessel(GetParam().water_margin);
  const std::vector<Layer>& layers_ = GetParam().layers;
  const glm::dvec3 eye_{0.1, 0.23, 2.0}, ahead_{0.1, 0.23, 0.0};
};

// The tolerance is what a few hundred branches cut at 1e-8 and the rounding of as many sums take.
TEST_P(Layers, StraightOnTheyTransmitTheSumOfTheirInnerBounces) {
  add_lamp_behind(scene_);
  const TraceSettings settings{
      .max_depth = 24, .importance_cutoff = 1e-8f, .fresnel = FresnelModel::Exact};
  EXPECT_NEAR(trace_ray(scene_, eye_, ahead_, settings).x,
              total_transmittance(reflectances(FresnelModel::Exact, layers_, 0.0)), 1e-5);
}

// Six surfaces are met on the straight way; one inner bounce would take two more.
TEST_P(Layers, WithoutInnerBouncesTheyTransmitTheProduct) {
  add_lamp_behind(scene_);
  for (const FresnelModel model : {FresnelModel::Schlick, FresnelModel::Exact}) {
    const TraceSettings settings{.max_depth = 6, .importance_cutoff = 0.0f, .fresnel = model};
    for (const double degrees : {0.0, 30.0, 60.0, 75.0}) {
      const double angle = degrees * std::numbers::pi / 180.0;
      const glm::dvec3 towards(std::tan(angle), 0.0, -1.0);
      const glm::dvec3 eye(0.1, 0.23, 1.1);
      EXPECT_NEAR(trace_ray(scene_, eye, eye + towards, settings).x,
                  straight_transmittance(reflectances(model, layers_, angle)), 2e-5)
          << degrees << (model == FresnelModel::Exact ? " exact" : " Schlick");
    }
  }
}

// At 45 degrees the ray leaves beside its old line, in its old direction: it meets targets of 0.2
// mm at the right place at two distances.
TEST_P(Layers, ShiftARayBySnell) {
  const double angle = std::numbers::pi / 4.0;
  const glm::dvec3 enters(0.1, 0.23, 1.0), direction(std::sin(angle), 0.0, -std::cos(angle));
  const glm::dvec3 leaves = glm::dvec3(0.1 + advance(layers_, angle), 0.23, 0.0);
  const TraceSettings settings{
      .max_depth = 6, .importance_cutoff = 0.0f, .fresnel = FresnelModel::Exact};
  for (const double distance : {0.1, 2.0}) {
    scene::Scene scene = scene_;
    constexpr float kHalf = 1e-4f;  // three times the height that rays start at in this scene
    add_object(scene,
               make_quad(glm::vec3(leaves + distance * direction), {kHalf, 0, 0}, {0, kHalf, 0}),
               emitter(1.0f), scene::Role::Virtual);
    EXPECT_NEAR(trace_ray(scene, enters - direction, enters, settings).x,
                straight_transmittance(reflectances(FresnelModel::Exact, layers_, angle)), 1e-5)
        << distance;
  }
}

TEST_P(Layers, EachAbsorbsByBeerLambert) {
  scene::Scene scene = vessel(GetParam().water_margin, true);
  add_lamp_behind(scene);
  const TraceSettings settings{
      .max_depth = 6, .importance_cutoff = 0.0f, .fresnel = FresnelModel::Exact};
  const glm::vec3 seen = trace_ray(scene, eye_, ahead_, settings);
  const double surfaces = straight_transmittance(reflectances(FresnelModel::Exact, layers_, 0.0));
  for (int c = 0; c < 3; ++c) {
    double depth = 0.0;
    for (const Layer& layer : layers_) depth += layer.thickness * double{layer.absorption[c]};
    EXPECT_NEAR(seen[c], surfaces * std::exp(-depth), 2e-6) << c;
  }
}

// A transform that mirrors turns triangles round and must not swap inside and outside. Boxes about
// the axis look the same mirrored, so all stays as it was.
TEST_P(Layers, StayTheSameMirrored) {
  scene::Scene scene = vessel(GetParam().water_margin, true);
  for (scene::Instance& instance : scene.instances) instance.anchor_from_mesh[0][0] = -1.0f;
  add_lamp_behind(scene);
  scene::Scene upright = vessel(GetParam().water_margin, true);
  add_lamp_behind(upright);
  const TraceSettings settings{.max_depth = 8, .importance_cutoff = 0.0f};
  const glm::dvec3 eye(0.1, 0.23, 1.1), towards(0.8, 0.1, -1.0);
  const glm::vec3 seen = trace_ray(scene, eye, eye + towards, settings),
                  expected = trace_ray(upright, eye, eye + towards, settings);
  EXPECT_LT(glm::distance(seen, expected), 1e-6f);
  EXPECT_GT(seen.z, 0.5f);
}

INSTANTIATE_TEST_SUITE_P(OfAVessel, Layers, testing::Values(kOverlapping, kWithGap),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace amalgam::trace
