// The renderer held to the reference on the scenes that come with Amalgam.
#include <gtest/gtest.h>

#include <iostream>
#include <tuple>

#include "parity/parity_row.h"
#include "support/compare_images.h"

namespace amalgam::parity {
namespace {

// Of all pixels: rays that graze an edge may fall on its other side in float.
constexpr double kMostGrazing = 0.002;
constexpr double kCompositeWrongShare = 1e-3;  // pixels off by more than 3/255
const test_support::Tolerance kComposite = {
    3.0, 1.0, "1/255: rounding to bytes; one pixel in a thousand may lie on an edge"};

using Parameters = std::tuple<const char*, int, frame::RendererMode>;

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
  const ParityCase parity_case = make_parity_case(scene_name, width, width * 3 / 4);
  const ParityRow row = compare_with_reference(parity_case, mode);
  std::cout << table_header() << table_line(parity_case, mode, row);

  const auto pixels = static_cast<double>(row.pixels);
  EXPECT_EQ(row.traced_wrong, 0u) << "beyond " << kTracedTolerance << ":" << row.worst;
  EXPECT_LT(static_cast<double>(row.edge + row.steep), kMostGrazing * pixels);
  const bool composite_agrees =
      row.composite_mean <= kComposite.mean &&
      static_cast<double>(row.composite_wrong) <= kCompositeWrongShare * pixels;
  EXPECT_TRUE(composite_agrees) << test_support::check_images(
      file_name(GetParam()), test_support::as_floats(row.composite),
      test_support::as_floats(reference_images(parity_case).composite), kComposite,
      AMALGAM_BINARY_DIR);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Parity,
    testing::Combine(testing::Values("complex", "diffuse", "mirror"), testing::Values(160, 320),
                     testing::Values(frame::RendererMode::Raytrace, frame::RendererMode::Hybrid)),
    test_name);

}  // namespace
}  // namespace amalgam::parity
