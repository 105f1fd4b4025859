// The renderer held to the reference on the scenes that come with Amalgam.
#include <gtest/gtest.h>

#include <iostream>
#include <tuple>

#include "parity/everything_case.h"
#include "parity/parity_row.h"
#include "support/compare_images.h"

namespace amalgam::parity {
namespace {

// Shares of all pixels.
struct TracedLimits {
  double grazing = 0.0;  // where rays may fall on the other side of an edge in float
  double wrong = 0.0;    // over tolerance without grazing anything
};
constexpr TracedLimits kOurScenes = {.grazing = 0.002, .wrong = 0.0};
// Glass in glass makes hundreds of branches a pixel, any of which may be the one at an edge or at
// the cut-off.
constexpr TracedLimits kEverything = {.grazing = 0.006, .wrong = 0.0};
constexpr double kCompositeWrongShare = 1e-3;  // pixels off by more than 3/255
const test_support::Tolerance kComposite = {
    3.0, 1.0, "1/255: rounding to bytes; one pixel in a thousand may lie on an edge"};

using Parameters = std::tuple<const char*, int, frame::RendererMode>;

void expect_parity(const ParityCase& parity_case, frame::RendererMode mode,
                   const TracedLimits& limits, const std::string& file_name) {
  const ParityRow row = compare_with_reference(parity_case, mode);
  std::cout << table_header() << table_line(parity_case, mode, row);

  const auto pixels = static_cast<double>(row.pixels);
  EXPECT_LE(static_cast<double>(row.traced_wrong), limits.wrong * pixels)
      << "beyond " << kTracedTolerance << ":" << row.worst;
  // Each sample of a pixel has its own chance to graze something.
  const int samples = parity_case.samples_per_side * parity_case.samples_per_side;
  EXPECT_LE(static_cast<double>(row.edge + row.steep), limits.grazing * samples * pixels);
  const bool composite_agrees =
      row.composite_mean <= kComposite.mean &&
      static_cast<double>(row.composite_wrong) <= kCompositeWrongShare * pixels;
  EXPECT_TRUE(composite_agrees) << test_support::check_images(
      file_name, test_support::as_floats(row.composite),
      test_support::as_floats(reference_images(parity_case).composite), kComposite,
      AMALGAM_BINARY_DIR);
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
  expect_parity(make_parity_case(scene_name, width, width * 3 / 4), mode, kOurScenes,
                file_name(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Parity,
    testing::Combine(testing::Values("complex", "diffuse", "mirror"), testing::Values(160, 320),
                     testing::Values(frame::RendererMode::Raytrace, frame::RendererMode::Hybrid)),
    test_name);

// Raytrace: rasterised shadows are another matter, and the scenes above show it.
TEST(ParityOfEverything, OneSampleAPixel) {
  expect_parity(make_everything_case(), frame::RendererMode::Raytrace, kEverything, "everything");
}

TEST(ParityOfEverything, ExactFresnelAndFourSamples) {
  ParityCase parity_case = make_everything_case();
  parity_case.name += " exact 2x2";
  parity_case.exact_fresnel = true;
  parity_case.samples_per_side = 2;
  expect_parity(parity_case, frame::RendererMode::Raytrace, kEverything, "everything-exact");
}

TEST(ParityOfEverything, BehindALens) {
  ParityCase parity_case = make_everything_case();
  parity_case.name += " lens";
  parity_case.camera.distortion = {-0.25, 0.08, 0.001, -0.0015, 0.01};
  expect_parity(parity_case, frame::RendererMode::Raytrace, kEverything, "everything-lens");
}

}  // namespace
}  // namespace amalgam::parity
