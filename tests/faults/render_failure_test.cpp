// Row 21: something fails in the renderer. The session whose frame it was ends; the server lives,
// and the others' frames stay what they were.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <utility>

#include "codec/jpeg.h"
#include "common/log.h"
#include "faults/failing_allocation.h"
#include "faults/figure.h"
#include "faults/known_cost_renderer.h"
#include "frame/default_view.h"
#include "frame/render_thread.h"
#include "frame/scene_renderer.h"
#include "support/net/server_around.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using protocol::Error;

// Fails in the way that a frame names: as OpenGL, Embree or the allocator would.
class FailingRenderer : public KnownCostRenderer {
 public:
  frame::FrameOutput render(State& state, const frame::FrameInput& input) override {
    const auto& bytes = std::get<frame::Bytes>(input.image);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text == "memory") throw std::bad_alloc();
    if (text == "OpenGL") throw std::runtime_error("OpenGL: 0x505 while making a texture");
    if (text == "Embree") throw std::runtime_error("Embree: out of memory");
    return KnownCostRenderer::render(state, input);
  }
};

TEST(RenderFailure, EndsItsSessionAndNoOther) {
  frame::RenderThread service([] { return std::make_unique<FailingRenderer>(); });
  ServerAround server(service);
  TestClient other = server.session();
  std::uint64_t id = 0;
  for (const char* failure : {"memory", "OpenGL", "Embree"}) {
    TestClient client = server.session();
    client.send(frame_message(1, "1"));
    client.expect(Envelope::kComposite);
    client.send(frame_message(2, failure));
    const Error error = client.expect_error(Error::INTERNAL);
    EXPECT_EQ(error.text(), "the frame could not be rendered") << "no inside for strangers";
    EXPECT_EQ(error.frame_id(), 2u);
    EXPECT_TRUE(client.closed_by_server());
    other.send(frame_message(++id, "1"));
    other.expect(Envelope::kComposite);
  }
  EXPECT_EQ(server.admin("/livez").status, 200);
  EXPECT_THAT(server.admin("/metrics").body, testing::HasSubstr("code=\"INTERNAL\"} 3"));
}

// The real renderer, but the render thread's allocations count while it renders.
class ArmedRenderer : public frame::ViewRenderer {
 public:
  explicit ArmedRenderer(std::unique_ptr<ViewRenderer> renderer) : inner_(std::move(renderer)) {}

  std::unique_ptr<State> open(const frame::ViewOptions& options) override {
    const Armed armed;
    return inner_->open(options);
  }
  frame::FrameOutput render(State& view, const frame::FrameInput& input) override {
    const Armed armed;
    return inner_->render(view, input);
  }
  void set_environment(const frame::EnvironmentInput& input) override {
    inner_->set_environment(input);
  }
  void set_own_environment(State& view, const frame::EnvironmentInput& input) override {
    inner_->set_own_environment(view, input);
  }
  frame::FrameService::MarkerSet markers() const override { return inner_->markers(); }

 private:
  struct Armed {
    Armed() { arm_this_thread(true); }
    ~Armed() { arm_this_thread(false); }
  };
  std::unique_ptr<ViewRenderer> inner_;
};

class Rendering {
 public:
  // The first frame of a view that exists for it alone.
  frame::FrameResult render() {
    std::promise<frame::FrameResult> result;
    const auto view = service_.open_view(
        {.camera = common::default_camera(64, 48)},
        [&](std::uint64_t, frame::FrameResult rendered) { result.set_value(std::move(rendered)); });
    service_.submit(view, 1, {jpeg_, {frame::default_pose(40)}});
    frame::FrameResult got = result.get_future().get();
    service_.close_view(view);
    return got;
  }

 private:
  static frame::MakeRenderer armed() {
    frame::RendererSettings settings;
    settings.mode = frame::RendererMode::Raytrace;  // no driver, whose threads are its own
    const auto make =
        frame::renderer_of_file(AMALGAM_SOURCE_DIR "/deploy/scenes/mirror.gltf", settings);
    return [make] { return std::make_unique<ArmedRenderer>(make()); };
  }

  frame::Bytes jpeg_ = codec::encode_jpeg(common::ImageRgb8(64, 48, common::Rgb8(128)), 90);
  frame::RenderThread service_{armed()};
};

TEST(RenderFailure, TheKthAllocationOfAFrameSpoilsNoOtherFrame) {
  common::set_log_level("off");
  Rendering rendering;
  const auto whole = std::get<frame::FrameOutput>(rendering.render()).jpeg;
  const std::uint64_t before = failed_allocations();
  const auto begin = std::chrono::steady_clock::now();
  std::int64_t k = 0;
  bool all = false;
  for (; k < 1000 && !all; ++k) {
    fail_allocation(k);
    const std::uint64_t failed = failed_allocations();
    const frame::FrameResult result = rendering.render();
    fail_no_allocation();
    all = failed_allocations() == failed;  // the frame needs no more than k
    if (const auto* output = std::get_if<frame::FrameOutput>(&result)) {
      EXPECT_TRUE(output->jpeg == whole) << "spoilt, and not told; allocation " << k;
    }
    if (k % 16 == 0) {
      const frame::FrameResult next = rendering.render();
      ASSERT_TRUE(std::holds_alternative<frame::FrameOutput>(next)) << "after allocation " << k;
      EXPECT_TRUE(std::get<frame::FrameOutput>(next).jpeg == whole) << "after allocation " << k;
    }
    if (std::chrono::steady_clock::now() - begin > std::chrono::seconds(3)) break;
  }
  print_figure("21", "allocations of a frame failed",
               static_cast<double>(failed_allocations() - before), all ? "(all of them)" : "",
               "all k <= 1000");
  EXPECT_GT(failed_allocations() - before, 50u);
}

}  // namespace
}  // namespace amalgam::test
