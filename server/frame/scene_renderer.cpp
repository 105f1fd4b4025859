#include "frame/scene_renderer.h"

#include <utility>

#include "codec/jpeg.h"
#include "common/log.h"
#include "core/timings.h"
#include "frame/default_view.h"
#include "frame/environment_input.h"
#include "frame/fingerprint.h"
#include "frame/frame_renderer.h"
#include "frame/view_state.h"
#include "scene/gltf/loader.h"
#include "scene/marker_ids.h"

namespace amalgam::frame {
namespace {

// Refuses an image of another size by its header, before it is decoded or anything drawn for it.
void check_size(const FrameInput& input, const common::CameraModel& camera) {
  const auto* const jpeg = std::get_if<Bytes>(&input.image);
  if (jpeg == nullptr) return;
  const codec::JpegHeader header = codec::read_jpeg_header(*jpeg);
  if (header.width == camera.width && header.height == camera.height) return;
  const auto size = [](int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
  };
  throw codec::JpegError("an image of " + size(header.width, header.height) + " pixels; " +
                         size(camera.width, camera.height) + " were agreed");
}

class SceneRenderer : public ViewRenderer {
 public:
  SceneRenderer(scene::Scene scene, const RendererSettings& settings)
      : fingerprint_(fingerprint_of(scene.path, settings)), renderer_(std::move(scene), settings) {
    fingerprint_.hardware = renderer_.hardware();
    for (const std::string& warning : renderer_.scene().warnings) common::log_warn(warning);
    // The first frame compiles shaders and draws shadow maps, for which the first client would wait
    // seconds, and on a busy machine so long that the renderer would be taken for stuck.
    render_for_nobody(160, 120);
    // The second one tells what a frame costs. It is as large as most clients', because small ones
    // cost more for each pixel.
    constexpr int kWidth = 640, kHeight = 480;
    seconds_per_pixel_ = render_for_nobody(kWidth, kHeight) / (kWidth * kHeight);
  }

  std::unique_ptr<State> open(const ViewOptions& options) override {
    return std::make_unique<OpenView>(options);
  }

  FrameOutput render(State& state, const FrameInput& input) override {
    ViewState& view = static_cast<OpenView&>(state).state;
    check_size(input, view.options.camera);
    return renderer_.render(view, input);
  }

  void set_environment(const EnvironmentInput& input) override {
    renderer_.set_environment(make_environment(input));
  }

  void set_own_environment(State& state, const EnvironmentInput& input) override {
    renderer_.set_own_environment(static_cast<OpenView&>(state).state, make_environment(input));
  }

  void free_targets() override { renderer_.free_targets(); }

  FrameService::MarkerSet markers() const override {
    const scene::Scene& scene = renderer_.scene();
    return {.dictionary = scene.world.dictionary,
            .marker_length = scene.world.marker_length,
            .world_marker = scene.world.marker,
            .ids = scene::marker_ids(scene)};
  }

  FrameService::Fingerprint fingerprint() const override { return fingerprint_; }
  void stay() override { renderer_.make_current(); }
  double seconds_per_pixel() const override { return seconds_per_pixel_; }

 private:
  struct OpenView : State {
    explicit OpenView(const ViewOptions& options) : state(options) {}
    ViewState state;
  };

  // Seconds that a client's frame takes. Passes run only for what is asked of a frame, so the image
  // is a JPEG, whose composite is asked for.
  double render_for_nobody(int width, int height) {
    ViewState view({.camera = common::default_camera(width, height)});
    const common::ImageRgb8 grey(width, height, common::Rgb8(128));
    const FrameInput input{codec::encode_jpeg(grey, 90),
                           {default_pose(renderer_.scene().world.marker)}};
    const core::Stopwatch stopwatch;
    renderer_.render(view, input);
    return stopwatch.milliseconds() / 1000.0;
  }

  FrameService::Fingerprint fingerprint_;
  FrameRenderer renderer_;
  double seconds_per_pixel_ = 0.0;
};

}  // namespace

MakeRenderer renderer_of_file(const std::string& scene_path, const RendererSettings& settings) {
  return [scene_path, settings] {
    return std::make_unique<SceneRenderer>(scene::load_scene(scene_path), settings);
  };
}

MakeRenderer renderer_of_scene(scene::Scene scene, const RendererSettings& settings) {
  return [scene = std::make_shared<scene::Scene>(std::move(scene)), settings] {
    return std::make_unique<SceneRenderer>(std::move(*scene), settings);
  };
}

}  // namespace amalgam::frame
