// What more samples a pixel cost, and adaptive ones.
#include <algorithm>

#include "bench/goals/measures.h"
#include "bench/picture_error.h"
#include "bench/render_rig.h"

namespace amalgam::bench {
namespace {

constexpr Rounds kRounds{.least = 1, .most = 5, .seconds = 12.0};

frame::RendererSettings with_samples(std::string_view samples) {
  frame::RendererSettings settings = default_settings();
  frame::parse_samples(samples, settings);
  return settings;
}

std::vector<BenchCase> cases(const GoalBench& bench) {
  std::vector<BenchCase> result;
  result.push_back(bench.scenes().complex(800, 600));
  result.push_back(bench.scenes().glass_bunny(800, 600));
  return result;
}

// Of two scenes, the one that is further from the goal (at most).
Measurement worse(const Measurement& a, const Measurement& b) {
  Measurement result = a.value >= b.value ? a : b;
  result.low = std::min(a.low, b.low);
  result.high = std::max(a.high, b.high);
  result.note = a.note + "; " + b.note;
  result.broken_condition = a.broken_condition ? a.broken_condition : b.broken_condition;
  return result;
}

Measurement measure_case(const BenchCase& bench_case, std::string_view above_samples,
                         std::string_view below_samples, bool compare) {
  RenderRig above(bench_case, with_samples(above_samples), {.keep_pixels = compare}),
      below(bench_case, with_samples(below_samples), {.keep_pixels = compare});
  const Ratio ratio = measure_by_turns(
      kRounds, [&] { return above.render_milliseconds(); },
      [&] { return below.render_milliseconds(); });
  Measurement measured = to_measurement(ratio, bench_case.name + ": " + describe(ratio));
  if (!compare) return measured;
  const double likeness = ssim(above.render().pixels, below.render().pixels);
  measured.note += ", SSIM " + std::to_string(likeness).substr(0, 6);
  if (likeness < 0.99) measured.broken_condition = bench_case.name + " is not like enough";
  return measured;
}

Measurement measure_both(GoalBench& bench, std::string_view above, std::string_view below,
                         bool compare) {
  const std::vector<BenchCase> scenes = cases(bench);
  return worse(measure_case(scenes[0], above, below, compare),
               measure_case(scenes[1], above, below, compare));
}

}  // namespace

Outcome measure_nine_samples(GoalBench& bench) {
  return measure_both(bench, "9", "1", false);
}

Outcome measure_adaptive(GoalBench& bench) {
  return measure_both(bench, "adaptive", "9", true);
}

}  // namespace amalgam::bench
