// A tracker's noise against the renderer's errors: how much of a composite's error is whose?
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "bench/bench_case.h"
#include "common/pose.h"
#include "report/reference_store.h"

namespace amalgam::report {

constexpr double kCornerNoise = 0.5;  // pixels, standard deviation on each axis
// A tracker's picture is this wide, whatever the composite's size: the noise is 0.5 pixels there.
constexpr double kTrackerWidth = 640.0;

// The pose that a tracker finds if each of the marker's corners is off by normal noise. Of the two
// poses that a flat marker leaves open it is the one nearer to the truth: flips are another matter.
// Throws std::runtime_error if the marker cannot be seen.
common::MarkerPose noisy_pose(const common::MarkerPose& true_pose, double marker_length,
                              const common::CameraModel& camera, double noise,
                              std::mt19937_64& random);

// Mean absolute errors, display-linear; means over all draws.
struct JitterErrors {
  std::string scene;
  int draws = 0;
  double marker_pixels = 0.0;  // the mean side of the marker in the tracker's picture
  double tracking = 0.0;       // noisy pose to true pose, both rendered by us, before JPEG
  double rendering = 0.0;      // true pose to the reference, before JPEG
  double jpeg = 0.0;           // after JPEG to before it
  double together = 0.0;       // noisy pose after JPEG to the reference
};

// With the default settings. The camera's picture is that of the true pose.
JitterErrors measure_jitter(const std::string& scene_name, const bench::BenchCase& bench_case,
                            ReferenceStore& references, double exposure, const ReferenceSpec& spec,
                            int draws);

}  // namespace amalgam::report
