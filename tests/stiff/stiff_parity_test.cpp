// The renderer held to the reference on stiff scenes, within the figures of tests/parity.
#include <gtest/gtest.h>

#include <iostream>

#include "parity/parity_row.h"
#include "parity/rendering.h"
#include "stiff/stiff_case.h"

namespace amalgam::stiff {
namespace {

using parity::ParityRow;
using test_support::StiffScene;

constexpr int kWidth = 48, kHeight = 36;

// Small pictures have more edge for their area than those of tests/parity.
constexpr double kMostGrazing = 0.05;         // of the pixels
constexpr double kMostGrazingWrong = 0.01;    // likewise, beyond the tolerance
constexpr double kMostCompositeWrong = 0.01;  // likewise, by more than 3/255

void expect_agreement(const parity::ParityCase& parity_case, frame::RendererMode mode) {
  const ParityRow row = parity::compare_with_reference(parity_case, mode);
  std::cout << parity::table_line(parity_case, mode, row);
  const auto pixels = static_cast<double>(row.pixels);
  EXPECT_GT(static_cast<double>(row.traced), 0.1 * pixels) << "the hard part is not in view";
  EXPECT_EQ(row.nonfinite, 0u);
  EXPECT_EQ(row.traced_wrong, 0u) << "beyond " << parity::kTracedTolerance << ":" << row.worst;
  EXPECT_LE(row.traced_mean, parity::kTracedMean);
  EXPECT_LE(static_cast<double>(row.traced_wrong_grazing), kMostGrazingWrong * pixels);
  EXPECT_LE(static_cast<double>(row.edge + row.steep + row.rim), kMostGrazing * pixels);
  EXPECT_LE(static_cast<double>(row.composite_wrong), kMostCompositeWrong * pixels);
}

class StiffParity : public testing::TestWithParam<std::string> {};

TEST_P(StiffParity, RendererAgreesWithReference) {
  const parity::ParityCase parity_case =
      make_case(test_support::stiff_scene(GetParam()), kWidth, kHeight);
  std::cout << parity::table_header();
  expect_agreement(parity_case, frame::RendererMode::Raytrace);
  expect_agreement(parity_case, frame::RendererMode::Hybrid);
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& c : name) {
    if (c == '-' || c == '.') c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, StiffParity,
                         testing::Values("corridor-0.5-1m", "corridor-0.999-1m",
                                         "corridor-0.95-1mm", "corridor-0.95-1km", "stack-2-1m",
                                         "stack-16-1m", "stack-8-1mm", "stack-4-1km",
                                         "ball-1.0001-1m", "ball-2.42-1m", "nested-1m",
                                         "nested-1mm", "nested-1km", "lens-1mm", "lens-1km"),
                         test_name);

}  // namespace
}  // namespace amalgam::stiff
