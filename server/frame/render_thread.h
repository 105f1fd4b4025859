// The one thread that renders. It owns the renderer (and with it the OpenGL context) and serves all
// views in turns (turns.h).
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "common/mailbox.h"
#include "core/progress.h"
#include "frame/frame.h"
#include "frame/renderer_settings.h"
#include "frame/turns.h"
#include "frame/view_renderer.h"

namespace amalgam::frame {

struct RenderServiceOptions {
  RendererSettings renderer;
};

class RenderThread : public FrameService {
 public:
  using Done = std::function<void(std::optional<std::string> error)>;

  // Makes the renderer on its thread; returns when it is ready. Throws what make throws.
  explicit RenderThread(const MakeRenderer& make);
  // Loads the scene. Throws as load_scene() and FrameRenderer do.
  RenderThread(const std::string& scene_path, const RenderServiceOptions& options);
  ~RenderThread() override { stop(); }

  // Cancels the frame in flight and drops waiting ones. When this returns, nothing that was handed
  // over (Deliver, Done) will be called any more.
  void stop();

  ViewId open_view(const ViewOptions& options, Deliver deliver) override;
  bool submit(ViewId view, std::uint64_t ticket, FrameInput input) override;
  void close_view(ViewId view) override;
  void set_environment(EnvironmentInput input, Done done) override;
  std::uint64_t memory_of(const EnvironmentInput& input) const override;
  MarkerSet markers() const override;
  Fingerprint fingerprint() const override;
  ServiceLoad load() const override;

  // Between two frames the renderer is replaced by another, for all views. If that cannot be made
  // the old one stays, and done is told why. done is called on the render thread and must not
  // throw.
  void replace_renderer(MakeRenderer make, Done done);

 private:
  using Clock = std::chrono::steady_clock;
  struct View;
  using Views = std::map<ViewId, std::shared_ptr<View>>;
  struct NewEnvironment {
    EnvironmentInput input;
    Done done;
  };
  struct NewRenderer {
    MakeRenderer make;
    Done done;
  };

  void run(const std::stop_token& stop, const MakeRenderer& make, std::promise<void>& started);
  // False when asked to stop.
  bool wait_for_work(const std::stop_token& stop);
  bool has_work(Clock::time_point now) const;  // under mutex_
  void begin_work();                           // under mutex_
  void apply_renderer();
  void adopt(std::unique_ptr<ViewRenderer> renderer);
  void apply_environment();
  void free_targets();
  // The view whose turn it is; null if nobody's is, or when asked to stop.
  std::shared_ptr<View> take_next_view(const std::stop_token& stop);
  void serve(View& view);
  void apply_own_environment(View& view);
  FrameResult render(View& view, FrameInput& input);

  mutable std::mutex mutex_;
  std::condition_variable_any work_;
  Views views_;              // under mutex_
  Turns turns_;              // under mutex_
  MarkerSet markers_;        // under mutex_
  Fingerprint fingerprint_;  // under mutex_
  ViewId last_id_ = 0;       // under mutex_
  ViewId serving_ = 0;       // under mutex_; 0: none
  bool has_other_ = false;   // under mutex_: something waits that is no frame
  // Under mutex_: the largest view has closed, and what was kept for its size can be freed.
  bool largest_closed_ = false;
  common::Mailbox<NewEnvironment> environment_;
  common::Mailbox<NewRenderer> renderer_to_be_;

  core::Progress progress_;
  // Whether a frame is rendered or an environment applied, and what was last seen of its progress.
  bool working_ = false;  // under mutex_
  mutable std::uint64_t steps_seen_ = 0;
  mutable Clock::time_point progress_seen_{};
  std::optional<Clock::time_point> reload_begun_;  // under mutex_; none: no renderer is being made

  std::unique_ptr<ViewRenderer> renderer_;  // the render thread's own
  std::jthread thread_;                     // last: everything else must outlive it
};

}  // namespace amalgam::frame
