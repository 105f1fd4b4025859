// A frame-time governor's pictures against those of full quality.
#include "bench/goals/measures.h"
#include "bench/picture_error.h"
#include "bench/render_rig.h"

namespace amalgam::bench {

Outcome measure_governed(GoalBench& bench) {
  constexpr double kTarget = 30.0;     // frames a second
  constexpr int kFramesToSettle = 30;  // for the governor to find what it may spend
  const BenchCase bunny = bench.scenes().glass_bunny(1280, 1024);
  frame::RendererSettings settings = default_settings();
  RenderRig full(bunny, settings, {.keep_pixels = true});
  settings.target_fps = kTarget;
  RenderRig governed(bunny, settings, {.keep_pixels = true});
  for (int i = 0; i < kFramesToSettle; ++i) governed.render();
  const double milliseconds = median_frame_milliseconds(governed, 3.0);
  const double likeness = ssim(governed.render().pixels, full.render().pixels);
  return Measurement{
      likeness, likeness, likeness,
      bunny.name + ": " + std::to_string(1000.0 / milliseconds).substr(0, 5) + " frames a second"};
}

}  // namespace amalgam::bench
