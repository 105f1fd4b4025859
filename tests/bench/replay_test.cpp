#include "bench/replay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "bench/bench_case.h"
#include "bench/camera_rays.h"
#include "support/scene_builders.h"
#include "trace/embree_scene.h"

namespace amalgam::bench {
namespace {

// A glass ball over a real floor.
BenchCase make_case() {
  BenchCase result;
  result.camera = common::default_camera(60, 44);
  result.scene.world.marker = 40;
  test_support::add_object(result.scene, test_support::make_floor(0.0f, 0.06f),
                           test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  test_support::add_object(result.scene, test_support::make_sphere({0, 0.05f, -0.09f}, 0.05f),
                           test_support::make_glass(), scene::Role::Virtual);
  result.input.poses = {bunny_pose()};
  return result;
}

// Rays that ask for the nearest hit, for any and for all by turns; every fifth sees real objects
// only.
std::vector<trace::LoggedRay> make_rays(const BenchCase& bench_case,
                                        const glm::dmat4& camera_from_world) {
  std::vector<trace::LoggedRay> rays;
  for (const trace::Ray& ray : camera_rays(bench_case.camera, camera_from_world)) {
    const std::size_t i = rays.size();
    constexpr std::array kQueries{trace::RayQuery::Nearest, trace::RayQuery::Any,
                                  trace::RayQuery::All};
    rays.push_back({ray, i % 5 == 0 ? trace::Visible::Real : trace::Visible::Everything,
                    kQueries[i % kQueries.size()]});
  }
  return rays;
}

TEST(Replay, MeetsWhatTheTracersSceneMeets) {
  const BenchCase bench_case = make_case();
  const auto anchored = scene::anchor_scene(bench_case.scene, bench_case.input.poses);
  const auto rays = make_rays(bench_case, anchored.camera_from_world);
  trace::EmbreeScene scene(bench_case.scene);
  scene.place(anchored);
  std::vector<ReplayAnswer> expected;
  for (const trace::LoggedRay& logged : rays) {
    if (logged.query != trace::RayQuery::Nearest) {
      expected.push_back(scene.is_occluded(logged.ray, logged.visible) ? ReplayAnswer{0, 0}
                                                                       : ReplayAnswer{});
      continue;
    }
    const auto hit = scene.intersect(logged.ray, logged.visible);
    expected.push_back(hit ? ReplayAnswer{hit->instance, hit->triangle} : ReplayAnswer{});
  }
  ASSERT_NE(std::count(expected.begin(), expected.end(), ReplayAnswer{}), 0);
  ASSERT_TRUE(std::any_of(expected.begin(), expected.end(),
                          [](const ReplayAnswer& a) { return a.instance == 1; }));

  const Replay replay(bench_case.scene, anchored);
  for (const ReplayCall call : {ReplayCall::OneByOne, ReplayCall::PacketsOfEight}) {
    for (const int threads : {1, 2}) {
      std::vector<ReplayAnswer> answers(rays.size());
      replay.run(rays, call, threads, answers);
      EXPECT_EQ(answers, expected);
    }
  }
}

}  // namespace
}  // namespace amalgam::bench
