// What more samples a pixel cost, and adaptive ones.
#include <algorithm>

#include "bench/goals/measures.h"
#include "bench/picture_error.h"
#include "bench/render_rig.h"
#include "core/timings.h"

namespace amalgam::bench {
namespace {

constexpr int kMostRounds = 5;
constexpr double kSeconds = 10.0;  // for a scene; no round begins later
constexpr double kAlike = 0.99;    // SSIM

frame::RendererSettings with_samples(std::string_view samples) {
  frame::RendererSettings settings = default_settings();
  frame::parse_samples(samples, settings);
  return settings;
}

SampleCosts measure_scene(const BenchCase& bench_case) {
  RenderRig one(bench_case, with_samples("1")),
      nine(bench_case, with_samples("9"), {.keep_pixels = true}),
      adaptive(bench_case, with_samples("adaptive"), {.keep_pixels = true});
  std::vector<double> one_times, nine_times, adaptive_times;
  common::ImageRgb8 nine_pixels, adaptive_pixels;
  const auto time = [](RenderRig& rig, common::ImageRgb8& pixels) {
    const core::Stopwatch stopwatch;
    pixels = rig.render().pixels;
    return stopwatch.milliseconds();
  };
  const core::Stopwatch stopwatch;
  do {
    one_times.push_back(one.render_milliseconds());
    nine_times.push_back(time(nine, nine_pixels));
    adaptive_times.push_back(time(adaptive, adaptive_pixels));
  } while (stopwatch.milliseconds() < 1000.0 * kSeconds && one_times.size() < kMostRounds);

  const Ratio nine_to_one = ratio_of_rounds(nine_times, one_times);
  const Ratio adaptive_to_nine = ratio_of_rounds(adaptive_times, nine_times);
  const double likeness = ssim(adaptive_pixels, nine_pixels);
  SampleCosts costs{
      to_measurement(nine_to_one, bench_case.name + ": " + describe(nine_to_one)),
      to_measurement(adaptive_to_nine, bench_case.name + ": " + describe(adaptive_to_nine) +
                                           ", SSIM " + std::to_string(likeness).substr(0, 6))};
  if (likeness < kAlike) costs.adaptive.broken_condition = bench_case.name + ": SSIM too low";
  return costs;
}

// Of two scenes, the one that is further from a goal of "at most".
Measurement worse(const Measurement& a, const Measurement& b) {
  Measurement result = a.value >= b.value ? a : b;
  result.low = std::min(a.low, b.low);
  result.high = std::max(a.high, b.high);
  result.note = a.note + "; " + b.note;
  result.broken_condition = a.broken_condition ? a.broken_condition : b.broken_condition;
  return result;
}

}  // namespace

const SampleCosts& GoalBench::samples() {
  if (!samples_) {
    const SampleCosts complex = measure_scene(scenes_.complex(800, 600));
    const SampleCosts bunny = measure_scene(scenes_.glass_bunny(800, 600));
    samples_ = {worse(complex.nine, bunny.nine), worse(complex.adaptive, bunny.adaptive)};
  }
  return *samples_;
}

Outcome measure_nine_samples(GoalBench& bench) {
  return bench.samples().nine;
}

Outcome measure_adaptive(GoalBench& bench) {
  return bench.samples().adaptive;
}

}  // namespace amalgam::bench
