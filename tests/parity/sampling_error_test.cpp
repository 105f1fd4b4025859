// What samples buy: error against rays and time, for fixed numbers of samples and for adaptive
// ones.
#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>
#include <vector>

#include "parity/rendering.h"
#include "support/compare_images.h"

namespace amalgam::parity {
namespace {

constexpr int kConvergedSide = 8;  // samples a side of the picture that errors are measured from

struct Point {
  std::string samples;
  double error = 0.0;      // mean over the composite, 1/255
  std::uint64_t rays = 0;  // of all kinds
  double time = 0.0;       // of a frame, milliseconds; rasterised samples cost no rays
};

std::uint64_t all_rays(const core::RayCounts& rays) {
  return rays.cast();
}

common::ImageRgb32f converged_composite(const ParityCase& parity_case) {
  const ParityCase converged = with_samples(parity_case, kConvergedSide);
  return test_support::as_floats(
      reference::render_reference(converged.scene, make_reference_request(converged)).composite);
}

Point measure(const std::string& samples, const ParityCase& parity_case,
              const frame::RendererSettings& settings, const common::ImageRgb32f& expected) {
  const Rendering rendering = render(parity_case, settings);
  return {samples,
          test_support::compare_images(test_support::as_floats(rendering.composite), expected).mean,
          all_rays(rendering.statistics.rays), median_frame_time(parity_case, settings)};
}

// 1, 4, 9 and 16 samples, then adaptive.
std::vector<Point> measure_all(const ParityCase& parity_case, frame::RendererMode mode,
                               const common::ImageRgb32f& expected) {
  frame::RendererSettings settings;
  settings.mode = mode;
  std::vector<Point> points;
  for (const int side : {1, 2, 3, 4}) {
    points.push_back(
        measure(std::to_string(side * side), with_samples(parity_case, side), settings, expected));
  }
  settings.adaptive_threshold = frame::kDefaultAdaptiveThreshold;
  points.push_back(measure("adaptive", parity_case, settings, expected));
  return points;
}

void print(const ParityCase& parity_case, frame::RendererMode mode,
           const std::vector<Point>& points) {
  for (const Point& point : points) {
    std::cout << std::left << std::setw(18) << parity_case.name << std::setw(10) << mode_name(mode)
              << std::setw(10) << point.samples << std::right << std::fixed << std::setprecision(4)
              << std::setw(12) << point.error << std::setw(12) << point.rays << std::setprecision(1)
              << std::setw(10) << point.time << '\n';
  }
}

TEST(SamplingError, FallsWithSamplesAndAdaptivePaysLess) {
  std::cout << "scene             renderer  samples   error 1/255        rays  frame ms\n";
  for (const char* scene : {"complex", "mirror"}) {
    const ParityCase parity_case = make_parity_case(scene, 160, 120);
    const common::ImageRgb32f expected = converged_composite(parity_case);
    for (const auto mode : {frame::RendererMode::Raytrace, frame::RendererMode::Hybrid}) {
      const std::vector<Point> points = measure_all(parity_case, mode, expected);
      print(parity_case, mode, points);
      const Point &four = points[1], &adaptive = points[4];
      // Nine rasterised samples of a diffuse surface cost no ray, nine adaptive ones do.
      const Point& dearer = points[mode == frame::RendererMode::Raytrace ? 2 : 3];
      for (std::size_t i = 1; i < 4; ++i) {
        EXPECT_LT(points[i].error, points[i - 1].error) << points[i].samples;
        EXPECT_GT(points[i].rays, points[i - 1].rays) << points[i].samples;
      }
      EXPECT_LT(adaptive.error, four.error);
      EXPECT_LT(adaptive.rays, dearer.rays);
    }
  }
}

}  // namespace
}  // namespace amalgam::parity
