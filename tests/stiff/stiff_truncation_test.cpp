// The bound that a frame states on what cutting rays off has changed, on scenes where that is much:
// it holds, and it is not so wide as to say nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "parity/composite_error.h"
#include "parity/rendering.h"
#include "stiff/stiff_case.h"

namespace amalgam::stiff {
namespace {

using parity::Error;
using parity::Rendering;

struct Cut {
  int depth;
  float importance;
};

Rendering render_cut(parity::ParityCase parity_case, const Cut& cut) {
  frame::RendererSettings settings;
  settings.mode = frame::RendererMode::Raytrace;
  parity_case.max_depth = cut.depth;
  parity_case.importance_cutoff = cut.importance;
  return parity::render(parity_case, settings);
}

// Followed as far as takes a second or so.
Cut endless_for(const test_support::StiffScene& stiff) {
  if (stiff.kind == test_support::StiffScene::Kind::Corridor) return {6000, 1e-4f};
  return {60, stiff.kind == test_support::StiffScene::Kind::Stack ? 1e-3f : 1e-4f};
}

TEST(StiffTruncation, BoundHoldsAndSaysSomething) {
  std::cout << "scene               depth  cut-off   mean error    bound    worst    bound\n";
  std::vector<double> mean_ratios, worst_ratios;
  for (const test_support::StiffScene& stiff : test_support::stiff_scenes()) {
    const parity::ParityCase parity_case = make_case(stiff, 24, 18);
    const Rendering endless = render_cut(parity_case, endless_for(stiff));
    const frame::TruncationBound& rest = endless.statistics.truncation_bound;
    for (const Cut& cut : {Cut{2, 0.0f}, {10, 0.05f}, {20, 0.01f}}) {
      const Rendering frame = render_cut(parity_case, cut);
      const Error error =
          parity::composite_error(parity_case.camera_image, frame.buffers, endless.buffers);
      const frame::TruncationBound& bound = frame.statistics.truncation_bound;
      std::cout << std::left << std::setw(20) << stiff.name << std::right << std::setw(5)
                << cut.depth << std::setw(9) << cut.importance << std::fixed << std::setprecision(5)
                << std::setw(13) << error.mean << std::setw(9) << bound.mean << std::setw(9)
                << error.worst << std::setw(9) << bound.worst << "  rest " << rest.mean
                << std::defaultfloat << '\n';
      constexpr double kRounding = 1e-5;  // of sums in float
      EXPECT_LE(error.mean, bound.mean + rest.mean + kRounding);
      EXPECT_LE(error.worst, bound.worst + rest.worst + kRounding);
      if (error.mean > kRounding) mean_ratios.push_back(bound.mean / error.mean);
      if (error.worst > kRounding) worst_ratios.push_back(bound.worst / error.worst);
    }
  }
  const auto median = [](std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    return values.at(values.size() / 2);
  };
  std::cout << "bound / error, median: mean " << median(mean_ratios) << ", worst "
            << median(worst_ratios) << " of " << mean_ratios.size() << " frames\n";
  EXPECT_LE(median(mean_ratios), 10.0);
  EXPECT_LE(median(worst_ratios), 10.0);
}

}  // namespace
}  // namespace amalgam::stiff
