// Raster and image passes: against the full diffuse pass, against tracing the whole image, and
// where nothing virtual shows.
#include "bench/full_diffuse.h"
#include "bench/goals/measures.h"
#include "bench/picture_error.h"
#include "bench/render_rig.h"
#include "bench/stage_sums.h"
#include "core/timings.h"

namespace amalgam::bench {
namespace {

double milliseconds_of(RenderRig& rig, const frame::FrameInput& input) {
  const core::Stopwatch stopwatch;
  rig.render(input);
  return stopwatch.milliseconds();
}

// input: of a frame that must come back as it went in.
Outcome measure_unaffected(const BenchCase& full, const frame::FrameInput& input) {
  RenderRig rig(full, default_settings());
  const frame::FrameOutput output = rig.render(input);
  const bool same = output.unchanged && output.jpeg == std::get<frame::Bytes>(input.image);
  const Ratio ratio = measure_by_turns(
      {}, [&] { return milliseconds_of(rig, input); }, [&] { return rig.render_milliseconds(); });
  Measurement measured = to_measurement(ratio, full.name + ": " + describe(ratio));
  if (!same) measured.broken_condition = "the client's bytes were changed";
  return measured;
}

}  // namespace

Outcome measure_raster_passes(GoalBench& bench) {
  const BenchCase bunny = bench.scenes().glass_bunny(1280, 1024);
  RenderRig rig(bunny, default_settings()), full(bunny, with_full_diffuse_pass(default_settings()));
  const Ratio ratio = measure_by_turns(
      {}, [&] { return raster_milliseconds(rig.render().statistics.stages); },
      [&] { return stage_milliseconds(full.render().statistics.stages, "diffuse"); });
  return to_measurement(ratio, bunny.name + ": " + describe(ratio));
}

Outcome measure_hybrid(GoalBench& bench) {
  const BenchCase complex = bench.scenes().complex(800, 600);
  frame::RendererSettings settings = default_settings();
  RenderRig hybrid(complex, settings, {.keep_pixels = true});
  settings.mode = frame::RendererMode::Raytrace;
  RenderRig traced(complex, settings, {.keep_pixels = true});
  const double difference = mean_difference(hybrid.render().pixels, traced.render().pixels);
  const Ratio ratio = measure_by_turns(
      {}, [&] { return traced.render_milliseconds(); },
      [&] { return hybrid.render_milliseconds(); });
  Measurement measured = to_measurement(
      ratio, complex.name + ": " + describe(ratio) + ", mean difference " +
                 std::to_string(difference).substr(0, 4) + "/255; the thesis had 1.71");
  constexpr double kSamePicture = 0.5;  // in 1/255: shadow maps are exact to a texel only
  if (difference > kSamePicture) measured.broken_condition = "the pictures differ";
  return measured;
}

Outcome measure_no_pose(GoalBench& bench) {
  const BenchCase bunny = bench.scenes().glass_bunny(1280, 1024);
  frame::FrameInput input = bunny.input;
  input.poses.clear();
  return measure_unaffected(bunny, input);
}

Outcome measure_nothing_in_view(GoalBench& bench) {
  const BenchCase bunny = bench.scenes().glass_bunny(1280, 1024);
  BenchCase aside = bunny;
  common::MarkerPose pose = bunny_pose();
  pose.translation.x += 0.4;  // the bunny and its shadows lie beyond the picture's right edge
  set_pose(aside, pose);
  return measure_unaffected(bunny, aside.input);
}

}  // namespace amalgam::bench
