// The tracer against itself on one thread, and against what Embree alone takes for its rays.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/goals/measures.h"
#include "bench/ray_log.h"
#include "bench/render_rig.h"
#include "bench/replay.h"
#include "bench/stage_sums.h"
#include "core/timings.h"

namespace amalgam::bench {
namespace {

double trace_milliseconds(RenderRig& rig) {
  return stage_milliseconds(rig.render().statistics.stages, "trace");
}

double milliseconds_of(const Replay& replay, const std::vector<trace::LoggedRay>& rays,
                       ReplayCall call, int threads, std::vector<ReplayAnswer>& answers) {
  const core::Stopwatch stopwatch;
  replay.run(rays, call, threads, answers);
  return stopwatch.milliseconds();
}

std::size_t count_differences(const std::vector<ReplayAnswer>& a,
                              const std::vector<ReplayAnswer>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] == b[i] ? 0 : 1;
  return count;
}

}  // namespace

Outcome measure_trace_threads(GoalBench& bench) {
  if (bench.cores() < 2) return NotMeasured{"this machine has one core"};
  const BenchCase bunny = bench.scenes().glass_bunny(1280, 1024);
  frame::RendererSettings one = default_settings();
  one.threads = 1;
  RenderRig single(bunny, one), both(bunny, default_settings());
  const Ratio ratio = measure_by_turns(
      {}, [&] { return trace_milliseconds(single); }, [&] { return trace_milliseconds(both); });
  return to_measurement(ratio, bunny.name + ": " + describe(ratio));
}

Outcome measure_trace_replay(GoalBench& bench) {
  const BenchCase bunny = bench.scenes().glass_bunny(1280, 1024);
  const trace::RayLog log = record_rays(bunny);
  if (log.rays.empty()) throw std::runtime_error("the tracer recorded no rays");
  const Replay replay(bunny.scene, scene::anchor_scene(bunny.scene, bunny.input.poses));
  std::vector<ReplayAnswer> singles(log.rays.size()), packets(log.rays.size());
  const auto run = [&](ReplayCall call) {
    return milliseconds_of(replay, log.rays, call, bench.cores(),
                           call == ReplayCall::OneByOne ? singles : packets);
  };
  run(ReplayCall::OneByOne);
  run(ReplayCall::PacketsOfEight);
  // Rays along an edge may be said to meet either triangle.
  const bool same_hits = count_differences(singles, packets) * 10000 <= singles.size();

  RenderRig rig(bunny, default_settings());
  double least_single = run(ReplayCall::OneByOne), least_packet = run(ReplayCall::PacketsOfEight);
  const auto fastest = [&] {
    const double single = run(ReplayCall::OneByOne), packet = run(ReplayCall::PacketsOfEight);
    least_single = std::min(least_single, single);
    least_packet = std::min(least_packet, packet);
    return same_hits ? std::min(single, packet) : single;
  };
  const Ratio ratio = measure_by_turns(
      {}, [&] { return trace_milliseconds(rig); }, fastest);
  return to_measurement(
      ratio, bunny.name + ": " + describe(ratio) + ", " + std::to_string(log.rays.size() / 1000) +
                 " k rays; least one by one " + std::to_string(std::lround(least_single)) +
                 " ms, by eight " + std::to_string(std::lround(least_packet)) + " ms" +
                 (same_hits ? "" : " with other hits, not counted"));
}

}  // namespace amalgam::bench
