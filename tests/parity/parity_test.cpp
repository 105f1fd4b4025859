// The renderer held to the reference on the scenes that come with Amalgam.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <tuple>

#include "parity/everything_case.h"
#include "parity/materials_case.h"
#include "parity/parity_row.h"
#include "support/compare_images.h"
#include "support/scene_builders.h"
#include "support/test_output.h"

namespace amalgam::parity {
namespace {

// Shares of all pixels.
struct Limits {
  double excused = 0.0005;  // traced, over tolerance where something is grazed or steep
  double grazing = 0.002;   // where rays may fall on the other side of an edge in float
};
constexpr double kCompositeWrongShare = 1e-3;  // off by more than 3/255
const test_support::Tolerance kComposite = {
    3.0, 0.1, "1/255: rounding to bytes; one pixel in a thousand may lie on an edge"};

// Ten times reflected in 69,666 facets a millimetre wide, light magnifies a rounding of float by
// dozens each time, so that a good part of the bunny's pixels meet other facets after it. Rays are
// followed in double, and all limits but the count of such pixels hold.
constexpr Limits kGlassBunny = {.grazing = 0.025};

using Parameters = std::tuple<const char*, int, frame::RendererMode>;

std::string show_traced(const ParityRow& row, const reference::ReferenceImages& expected,
                        const std::string& name) {
  return "\n" +
         test_support::show_failure(name + "-mixed", row.mixed,
                                    test_support::as_floats(expected.mixed), row.traced_errors,
                                    kTracedTolerance) +
         test_support::write_test_output(name + "-real", row.real,
                                         test_support::as_floats(expected.real));
}

void expect_parity(const ParityCase& parity_case, frame::RendererMode mode, const Limits& limits,
                   const std::string& file_name) {
  const ParityRow row = compare_with_reference(parity_case, mode);
  std::cout << table_header() << table_line(parity_case, mode, row);

  const auto pixels = static_cast<double>(row.pixels);
  EXPECT_EQ(row.traced_wrong, 0u) << "beyond " << kTracedTolerance << ":" << row.worst
                                  << show_traced(row, reference_images(parity_case), file_name);
  EXPECT_LE(row.traced_mean, kTracedMean);
  EXPECT_LE(static_cast<double>(row.traced_wrong_grazing), limits.excused * pixels);
  // Each sample of a pixel has its own chance to graze something.
  const int samples = parity_case.samples_per_side * parity_case.samples_per_side;
  EXPECT_LE(static_cast<double>(row.edge + row.rim), limits.grazing * samples * pixels);
  test_support::Tolerance composite = kComposite;
  composite.set_aside = static_cast<std::size_t>(kCompositeWrongShare * pixels);
  EXPECT_TRUE(test_support::images_agree(
      file_name + "-composite", test_support::as_floats(row.composite),
      test_support::as_floats(reference_images(parity_case).composite), composite));
}

std::string file_name(const Parameters& parameters) {
  const auto& [scene_name, width, mode] = parameters;
  return std::string(scene_name) + std::to_string(width) +
         (mode == frame::RendererMode::Hybrid ? "Hybrid" : "Raytrace");
}

std::string test_name(const testing::TestParamInfo<Parameters>& info) {
  return file_name(info.param);
}

class Parity : public testing::TestWithParam<Parameters> {};

TEST_P(Parity, RendererAgreesWithReference) {
  const auto& [scene_name, width, mode] = GetParam();
  expect_parity(make_parity_case(scene_name, width, width * 3 / 4), mode, {},
                file_name(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Parity,
    testing::Combine(testing::Values("complex", "diffuse", "glassware", "markers", "mirror"),
                     testing::Values(160, 320),
                     testing::Values(frame::RendererMode::Raytrace, frame::RendererMode::Hybrid)),
    test_name);

// Of 69,666 triangles, made from a Debian package when Amalgam is set up.
class ParityOfBunnies : public testing::TestWithParam<Parameters> {};

TEST_P(ParityOfBunnies, RendererAgreesWithReference) {
  const auto& [material, width, mode] = GetParam();
  const std::string scene_name = std::string("generated/bunny-") + material;
  if (!std::filesystem::exists(scene_path(scene_name)))
    GTEST_SKIP() << "there is no " << scene_path(scene_name) << ": deploy/fetch_assets.sh makes it";
  ParityCase parity_case = make_parity_case(scene_name, width, width * 3 / 4);
  expect_parity(parity_case, mode, std::string(material) == "glass" ? kGlassBunny : Limits{},
                "bunny-" + file_name(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(
    Bunnies, ParityOfBunnies,
    testing::Combine(testing::Values("glass", "mirror"), testing::Values(160, 320),
                     testing::Values(frame::RendererMode::Raytrace, frame::RendererMode::Hybrid)),
    test_name);

// With fewer reflections the glass one is no exception.
TEST(ParityOfShallowBunnies, RendererAgreesWithReference) {
  if (!std::filesystem::exists(scene_path("generated/bunny-glass")))
    GTEST_SKIP() << "there is no glass bunny: deploy/fetch_assets.sh makes it";
  for (const int depth : {1, 2}) {
    ParityCase parity_case = make_parity_case("generated/bunny-glass", 160, 120);
    parity_case.name += " depth " + std::to_string(depth);
    parity_case.max_depth = depth;
    expect_parity(parity_case, frame::RendererMode::Raytrace, {},
                  "bunny-depth-" + std::to_string(depth));
  }
}

// A made-up scene in both modes, at once: the reference's picture is the same.
void expect_parity_in_both_modes(const ParityCase& parity_case, const Limits& limits,
                                 const std::string& file_name) {
  expect_parity(parity_case, frame::RendererMode::Raytrace, limits, file_name + "-raytrace");
  expect_parity(parity_case, frame::RendererMode::Hybrid, limits, file_name + "-hybrid");
}

TEST(ParityOfEverything, OneSampleAPixel) {
  expect_parity_in_both_modes(make_everything_case(), {}, "everything");
}

// The thesis's eq. 4.5.
TEST(ParityOfEverything, ByDifference) {
  ParityCase parity_case = make_everything_case();
  parity_case.name += " by difference";
  parity_case.by_difference = true;
  expect_parity_in_both_modes(parity_case, {}, "everything-by-difference");
}

TEST(ParityOfEverything, OfALinearCamera) {
  ParityCase parity_case = make_everything_case();
  parity_case.name += " linear";
  parity_case.linear_response = true;
  expect_parity_in_both_modes(parity_case, {}, "everything-linear");
}

TEST(ParityOfEverything, UnderWater) {
  ParityCase parity_case = make_everything_case();
  parity_case.name += " under water";
  test_support::add_object(parity_case.scene,
                           test_support::make_box({-0.6f, -0.1f, -0.5f}, {0.5f, 0.45f, 0.7f}),
                           test_support::make_glass(1.33f, {2.0f, 1.0f, 0.5f}), scene::Role::Real);
  expect_parity_in_both_modes(parity_case, {}, "everything-under-water");
}

TEST(ParityOfMaterials, OneSampleAPixel) {
  expect_parity_in_both_modes(make_materials_case(), {}, "materials");
}

TEST(ParityOfMaterials, FourSamplesBehindALens) {
  ParityCase parity_case = with_samples(make_materials_case(), 2);
  parity_case.name += " lens";
  parity_case.camera.distortion = {-0.25, 0.08, 0.001, -0.0015, 0.01};
  expect_parity_in_both_modes(parity_case, {}, "materials-lens");
}

TEST(ParityOfEverything, ExactFresnelAndFourSamples) {
  ParityCase parity_case = with_samples(make_everything_case(), 2);
  parity_case.name += " exact";
  parity_case.exact_fresnel = true;
  expect_parity_in_both_modes(parity_case, {}, "everything-exact");
}

TEST(ParityOfEverything, BehindALens) {
  ParityCase parity_case = make_everything_case();
  parity_case.name += " lens";
  parity_case.camera.distortion = {-0.25, 0.08, 0.001, -0.0015, 0.01};
  expect_parity_in_both_modes(parity_case, {}, "everything-lens");
}

}  // namespace
}  // namespace amalgam::parity
