// A frame whose light is all denormal against the same frame in ordinary light (numerics B24: at
// most 1.05 times its time).
#include "bench/micro/benchmarks.h"
#include "frame/default_view.h"
#include "frame/frame_renderer.h"
#include "support/scene_builders.h"

namespace amalgam::bench {
namespace {

// The inside of a glowing mirror box: each sample sums up a hundred products of weight and light.
void render_mirror_box(benchmark::State& state, float glow) {
  constexpr int kMarker = 40;
  scene::Scene scene;
  scene.world.marker = kMarker;
  scene::Material mirror = test_support::make_mirror(glm::vec3(0.5f));
  mirror.emission = glm::vec3(glow);
  test_support::add_object(scene, test_support::make_box(glm::vec3(-2.0f), glm::vec3(2.0f)), mirror,
                           scene::Role::Virtual);
  frame::RendererSettings settings;
  settings.mode = frame::RendererMode::Raytrace;
  settings.trace = {.max_depth = 100, .importance_cutoff = 0.0f};
  settings.exposure = 1.0f;
  settings.reuse_still_frames = false;
  settings.threads = 1;
  frame::FrameRenderer renderer(std::move(scene), settings);
  frame::ViewOptions options{.camera = common::default_camera(64, 48)};
  options.keep_pixels = true;
  frame::ViewState view(options);
  const frame::FrameInput input{common::ImageRgb8(64, 48, common::Rgb8(128)),
                                {frame::default_pose(kMarker)}};
  for (auto _ : state) benchmark::DoNotOptimize(renderer.render(view, input));
  state.SetItemsProcessed(state.iterations() * 64 * 48);
}

}  // namespace

void benchmark_bright_frame(benchmark::State& state) {
  render_mirror_box(state, 1.0f);
}

void benchmark_denormal_frame(benchmark::State& state) {
  render_mirror_box(state, 1e-39f);
}

}  // namespace amalgam::bench
