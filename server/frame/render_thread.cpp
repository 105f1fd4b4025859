#include "frame/render_thread.h"

#include <algorithm>
#include <stdexcept>

#include "codec/jpeg.h"
#include "common/log.h"
#include "frame/default_view.h"
#include "frame/environment_input.h"
#include "frame/frame_renderer.h"
#include "frame/view_state.h"
#include "scene/gltf/loader.h"
#include "scene/marker_ids.h"

namespace amalgam::frame {
namespace {

FrameService::MarkerSet marker_set(const scene::Scene& scene) {
  return {.dictionary = scene.world.dictionary,
          .marker_length = scene.world.marker_length,
          .world_marker = scene.world.marker,
          .ids = scene::marker_ids(scene)};
}

// Renders a small frame and drops it. This compiles shaders and draws shadow maps; otherwise the
// first client would wait seconds for them.
void warm_up(FrameRenderer& renderer) {
  ViewState view({.camera = common::default_camera(160, 120)});
  const common::ImageRgb8 grey(view.options.camera.width, view.options.camera.height,
                               common::Rgb8(128));
  renderer.render(view, {grey, {default_pose(renderer.scene().world.marker)}});
}

}  // namespace

struct RenderThread::View {
  View(const ViewOptions& options, Deliver deliver_to)
      : state(options), deliver(std::move(deliver_to)) {}

  struct Waiting {
    std::uint64_t frame_id = 0;
    FrameInput input;
  };

  ViewState state;  // used by the render thread only
  common::Mailbox<Waiting> mailbox;
  bool has_work = false;  // under RenderThread::mutex_
  std::mutex delivering;
  bool closed = false;  // under delivering
  Deliver deliver;
};

RenderThread::RenderThread(const std::string& scene_path, const RenderServiceOptions& options) {
  std::promise<MarkerSet> started;
  auto ready = started.get_future();
  thread_ = std::jthread([this, &scene_path, &options, &started](std::stop_token stop) {
    run(std::move(stop), scene_path, options, started);
  });
  markers_ = ready.get();
}

RenderThread::~RenderThread() = default;

ViewId RenderThread::open_view(const ViewOptions& options, Deliver deliver) {
  auto view = std::make_shared<View>(options, std::move(deliver));
  const std::lock_guard lock(mutex_);
  views_.emplace(++last_id_, std::move(view));
  return last_id_;
}

bool RenderThread::submit(ViewId id, std::uint64_t frame_id, FrameInput input) {
  std::optional<View::Waiting> replaced;  // freed after the lock
  {
    const std::lock_guard lock(mutex_);
    const auto found = views_.find(id);
    if (found == views_.end()) return false;
    replaced = found->second->mailbox.put({frame_id, std::move(input)});
    found->second->has_work = true;
  }
  work_.notify_one();
  return replaced.has_value();
}

void RenderThread::close_view(ViewId id) {
  std::shared_ptr<View> view;
  {
    const std::lock_guard lock(mutex_);
    const auto found = views_.find(id);
    if (found == views_.end()) return;
    view = std::move(found->second);
    views_.erase(found);
  }
  const std::lock_guard lock(view->delivering);
  view->closed = true;
}

void RenderThread::set_environment(EnvironmentInput input,
                                   std::function<void(std::optional<std::string> error)> done) {
  std::optional<NewEnvironment> replaced;
  {
    const std::lock_guard lock(mutex_);
    replaced = environment_.put({std::move(input), std::move(done)});
    has_environment_ = true;
  }
  work_.notify_one();
  if (replaced) replaced->done("replaced by a newer environment before it was used");
}

void RenderThread::apply_environment(FrameRenderer& renderer) {
  auto update = environment_.take();
  if (!update) return;
  try {
    renderer.set_environment(make_environment(update->input));
    update->done(std::nullopt);
  } catch (const std::exception& error) {
    update->done(error.what());
  }
}

void RenderThread::run(std::stop_token stop, const std::string& scene_path,
                       const RenderServiceOptions& options, std::promise<MarkerSet>& started) {
  std::optional<FrameRenderer> renderer;
  try {
    renderer.emplace(scene::load_scene(scene_path), options.renderer);
    for (const std::string& warning : renderer->scene().warnings) common::log_warn(warning);
    warm_up(*renderer);
    started.set_value(marker_set(renderer->scene()));
  } catch (...) {
    started.set_exception(std::current_exception());
    return;
  }
  // The constructor has returned: from here on neither the options nor the promise may be used.
  while (wait_for_work(stop)) {
    apply_environment(*renderer);
    if (const auto view = take_next_view()) serve(*renderer, *view);
  }
}

RenderThread::Views::iterator RenderThread::find_next_view() {
  const auto has_work = [](const auto& entry) { return entry.second->has_work; };
  const auto after = std::find_if(views_.upper_bound(last_served_), views_.end(), has_work);
  return after != views_.end() ? after : std::find_if(views_.begin(), views_.end(), has_work);
}

bool RenderThread::wait_for_work(std::stop_token stop) {
  std::unique_lock lock(mutex_);
  work_.wait(lock, stop, [&] { return has_environment_ || find_next_view() != views_.end(); });
  has_environment_ = false;
  return !stop.stop_requested();
}

std::shared_ptr<RenderThread::View> RenderThread::take_next_view() {
  const std::lock_guard lock(mutex_);
  const auto next = find_next_view();
  if (next == views_.end()) return nullptr;
  next->second->has_work = false;
  last_served_ = next->first;
  return next->second;
}

void RenderThread::serve(FrameRenderer& renderer, View& view) {
  auto waiting = view.mailbox.take();
  if (!waiting) return;
  FrameResult result;
  try {
    result = renderer.render(view.state, waiting->input);
  } catch (const codec::JpegError& error) {
    result = FrameFailure{FrameFailure::Kind::BadImage, error.what()};
  } catch (const std::exception& error) {
    common::log_error("frame " + std::to_string(waiting->frame_id) + " failed: " + error.what());
    result = FrameFailure{FrameFailure::Kind::Internal, error.what()};
  }
  const std::lock_guard lock(view.delivering);
  if (!view.closed) view.deliver(waiting->frame_id, std::move(result));
}

std::unique_ptr<FrameService> make_render_service(const std::string& scene_path,
                                                  const RenderServiceOptions& options) {
  return std::make_unique<RenderThread>(scene_path, options);
}

}  // namespace amalgam::frame
