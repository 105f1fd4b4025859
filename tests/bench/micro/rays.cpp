// Single rays against the bunny, as the tracer asks for them.
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "bench/bench_case.h"
#include "bench/camera_rays.h"
#include "bench/micro/benchmarks.h"
#include "support/scene_builders.h"
#include "trace/embree_scene.h"

namespace amalgam::bench {
namespace {

BenchCase bunny_or_sphere(const std::filesystem::path& scene_folder) {
  constexpr int kWidth = 320, kHeight = 256;
  try {
    return BenchScenes(scene_folder).glass_bunny(kWidth, kHeight);
  } catch (const MissingScene&) {
    BenchCase sphere;
    sphere.camera = common::default_camera(kWidth, kHeight);
    sphere.scene.world.marker = 40;
    test_support::add_object(sphere.scene, test_support::make_sphere({0, 0.05f, -0.09f}, 0.05f),
                             test_support::make_glass(), scene::Role::Virtual);
    set_pose(sphere, bunny_pose());
    return sphere;
  }
}

template <typename Ask>
void ask_for_camera_rays(benchmark::State& state, const std::filesystem::path& scene_folder,
                         const Ask& ask) {
  const BenchCase bunny = bunny_or_sphere(scene_folder);
  trace::EmbreeScene scene(bunny.scene);
  const scene::AnchoredScene anchored = scene::anchor_scene(bunny.scene, bunny.input.poses);
  scene.place(anchored);
  const std::vector<trace::Ray> rays = camera_rays(bunny.camera, anchored.camera_from_world);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(ask(scene, rays[i++ % rays.size()]));
  state.SetItemsProcessed(state.iterations());
}

}  // namespace

void benchmark_intersect(benchmark::State& state, const std::filesystem::path& scene_folder) {
  ask_for_camera_rays(state, scene_folder,
                      [](const trace::EmbreeScene& scene, const trace::Ray& ray) {
                        return scene.intersect(ray, trace::Visible::Everything);
                      });
}

void benchmark_is_occluded(benchmark::State& state, const std::filesystem::path& scene_folder) {
  ask_for_camera_rays(state, scene_folder,
                      [](const trace::EmbreeScene& scene, const trace::Ray& ray) {
                        return scene.is_occluded(ray, trace::Visible::Everything);
                      });
}

}  // namespace amalgam::bench
