// The one thread that renders. It owns the renderer (and with it the OpenGL context) and serves all
// views in turn.
#pragma once

#include <condition_variable>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "common/mailbox.h"
#include "frame/frame.h"
#include "frame/renderer_settings.h"

namespace amalgam::frame {

class FrameRenderer;
struct ViewState;

struct RenderServiceOptions {
  RendererSettings renderer;
};

class RenderThread : public FrameService {
 public:
  // Loads the scene and starts the renderer; returns when it is ready. Throws as load_scene() and
  // FrameRenderer do.
  RenderThread(const std::string& scene_path, const RenderServiceOptions& options);
  // Finishes the frame in flight; waiting frames are dropped.
  ~RenderThread() override;

  ViewId open_view(const ViewOptions& options, Deliver deliver) override;
  bool submit(ViewId view, std::uint64_t frame_id, FrameInput input) override;
  void close_view(ViewId view) override;
  void set_environment(EnvironmentInput input,
                       std::function<void(std::optional<std::string> error)> done) override;
  MarkerSet markers() const override { return markers_; }

 private:
  struct View;
  using Views = std::map<ViewId, std::shared_ptr<View>>;
  struct NewEnvironment {
    EnvironmentInput input;
    std::function<void(std::optional<std::string> error)> done;
  };

  void run(std::stop_token stop, const std::string& scene_path, const RenderServiceOptions& options,
           std::promise<MarkerSet>& started);
  // False when asked to stop.
  bool wait_for_work(std::stop_token stop);
  // The next view in turn that has a frame waiting; null if none has.
  std::shared_ptr<View> take_next_view();
  Views::iterator find_next_view();  // under mutex_
  void apply_environment(FrameRenderer& renderer);
  static void serve(FrameRenderer& renderer, View& view);

  mutable std::mutex mutex_;
  std::condition_variable_any work_;
  Views views_;  // under mutex_
  common::Mailbox<NewEnvironment> environment_;
  bool has_environment_ = false;  // under mutex_
  ViewId last_id_ = 0;            // under mutex_
  ViewId last_served_ = 0;        // under mutex_
  MarkerSet markers_;
  std::jthread thread_;  // last: everything else must outlive it
};

std::unique_ptr<FrameService> make_render_service(const std::string& scene_path,
                                                  const RenderServiceOptions& options);

}  // namespace amalgam::frame
