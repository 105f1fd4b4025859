// Row 21: calls into the graphics driver and the ray tracer fail. The frame is refused or right,
// and the next one is right.
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "codec/jpeg.h"
#include "common/log.h"
#include "faults/failing_driver.h"
#include "faults/figure.h"
#include "frame/default_view.h"
#include "frame/render_thread.h"
#include "frame/scene_renderer.h"
#include "scene/gltf/loader.h"
#include "trace/embree_scene.h"

namespace amalgam::test {
namespace {

using std::chrono::steady_clock;

class Rendering {
 public:
  explicit Rendering(frame::RendererMode mode) {
    frame::RendererSettings settings;
    settings.mode = mode;
    settings.env_lights = scene::parse_env_light_options("median-cut:1");  // for speed
    service_.emplace(
        frame::renderer_of_file(AMALGAM_SOURCE_DIR "/deploy/scenes/markers.gltf", settings));
  }

  // The first frame of a view that exists for it alone. Frames with different numbers have an
  // object at different places, so that no shadow and no placement is kept from one to the next.
  frame::FrameResult render(int number) {
    std::promise<frame::FrameResult> result;
    const auto view = service_->open_view(
        {.camera = common::default_camera(64, 48)},
        [&](std::uint64_t, frame::FrameResult rendered) { result.set_value(std::move(rendered)); });
    const common::MarkerPose world = frame::default_pose(service_->markers().world_marker);
    common::MarkerPose sphere = world;
    sphere.marker = 62;
    sphere.translation.x += 0.05 + 0.01 * number;
    service_->submit(view, 1, {jpeg_, {world, sphere}});
    frame::FrameResult got = result.get_future().get();
    service_->close_view(view);
    return got;
  }
  frame::Bytes rendered(int number) { return std::get<frame::FrameOutput>(render(number)).jpeg; }

 private:
  frame::Bytes jpeg_ = codec::encode_jpeg(common::ImageRgb8(64, 48, common::Rgb8(128)), 90);
  std::optional<frame::RenderThread> service_;
};

struct Injection {
  const char* what;
  frame::RendererMode mode;
  std::function<void(std::int64_t)> fail;
  std::function<std::uint64_t()> failed;
};

void expect_only_right_frames(const Injection& injection, std::chrono::seconds time) {
  common::set_log_level("off");
  Rendering rendering(injection.mode);
  const frame::Bytes whole[] = {rendering.rendered(0), rendering.rendered(1)};
  ASSERT_NE(whole[0], whole[1]);
  if (injection.mode != frame::RendererMode::Raytrace) {
    static const bool watched = [] {
      watch_opengl();
      return true;
    }();
    ASSERT_TRUE(watched);
  }
  const std::uint64_t before = injection.failed();
  const auto begin = steady_clock::now();
  bool all = false;
  int refused = 0;
  for (std::int64_t k = 0; k < 1000 && !all && steady_clock::now() - begin < time; ++k) {
    const std::uint64_t failed = injection.failed();
    injection.fail(k);
    const frame::FrameResult result = rendering.render(0);
    injection.fail(-1);
    all = injection.failed() == failed;  // the frame makes no more than k calls
    if (const auto* output = std::get_if<frame::FrameOutput>(&result)) {
      EXPECT_TRUE(output->jpeg == whole[0]) << "spoilt, and not told; " << k;
    } else {
      ++refused;
    }
    for (const int next : {1, 0, 1}) {
      const frame::FrameResult after = rendering.render(next);
      ASSERT_TRUE(std::holds_alternative<frame::FrameOutput>(after)) << "after " << k;
      EXPECT_TRUE(std::get<frame::FrameOutput>(after).jpeg == whole[next]) << "after " << k;
    }
  }
  const auto failed = static_cast<double>(injection.failed() - before);
  print_figure("21", injection.what, failed, all ? "(all of them)" : "", "all k <= 1000");
  EXPECT_GT(failed, 0.0);
  EXPECT_GT(refused, 0);
}

TEST(DriverFailure, TheKthCallOfOpenGlSpoilsNoOtherFrame) {
  expect_only_right_frames({"OpenGL calls of a frame failed", frame::RendererMode::Hybrid,
                            fail_opengl_call, failed_opengl_calls},
                           std::chrono::seconds(8));
}

TEST(DriverFailure, TheKthCommitOfEmbreeSpoilsNoOtherFrame) {
  expect_only_right_frames({"Embree's commits of a frame failed", frame::RendererMode::Raytrace,
                            fail_embree_commit, failed_embree_commits},
                           std::chrono::seconds(5));
}

TEST(DriverFailure, ASceneForWhichEmbreeHasNoMemoryIsRefused) {
  common::set_log_level("off");
  const scene::Scene scene = scene::load_scene(AMALGAM_SOURCE_DIR "/deploy/scenes/complex.gltf");
  std::int64_t k = 0;
  for (; k < 1000; ++k) {
    const std::uint64_t failed = failed_embree_allocations();
    fail_embree_allocation(k);
    bool refused = false;
    try {
      const trace::EmbreeScene built(scene);
    } catch (const std::runtime_error&) {
      refused = true;
    }
    fail_embree_allocation(-1);
    const bool did_fail = failed_embree_allocations() != failed;
    EXPECT_EQ(refused, did_fail) << "allocation " << k;
    if (!did_fail) break;
  }
  print_figure("21", "Embree's allocations of a scene failed", static_cast<double>(k), "(all)",
               "all k <= 1000");
  EXPECT_GT(k, 10);
}

}  // namespace
}  // namespace amalgam::test
