#include "bench/render_rig.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "bench/series.h"
#include "bench/two_cores.h"
#include "core/timings.h"
#include "frame/frame_renderer.h"

namespace amalgam::bench {
namespace {

frame::ViewOptions view_options(const common::CameraModel& camera, const RigOptions& options) {
  return {
      .camera = camera, .jpeg_quality = options.jpeg_quality, .keep_pixels = options.keep_pixels};
}

}  // namespace

frame::RendererSettings default_settings() {
  frame::RendererSettings settings;
  settings.threads = bench_cores();
  settings.reuse_still_frames = false;  // a moving camera, although it stands here
  return settings;
}

// The thread that owns the renderer. One job at a time: whoever gives one waits for it.
class RenderRig::Worker {
 public:
  Worker(const BenchCase& bench_case, const frame::RendererSettings& settings,
         const RigOptions& options) {
    run([&] {
      renderer_.emplace(bench_case.scene, settings);
      view_.emplace(view_options(bench_case.camera, options));
    });
  }
  ~Worker() {
    run([&] { renderer_.reset(); });  // on the thread that made it
  }

  frame::FrameOutput render(const frame::FrameInput& input, frame::FrameBuffers* buffers) {
    frame::FrameOutput output;
    run([&] { output = renderer_->render(*view_, input, buffers); });
    return output;
  }

  void look_through(const common::CameraModel& camera, const RigOptions& options) {
    run([&] { view_.emplace(view_options(camera, options)); });
  }

 private:
  void run(const std::function<void()>& job) {
    std::packaged_task<void()> task(job);
    std::future<void> done = task.get_future();
    {
      const std::lock_guard lock(mutex_);
      task_ = std::move(task);
    }
    given_.notify_one();
    done.get();
  }

  void serve(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    while (given_.wait(lock, stop, [&] { return task_.has_value(); })) {
      std::packaged_task<void()> task = std::move(*task_);
      task_.reset();
      task();
    }
  }

  std::mutex mutex_;
  std::condition_variable_any given_;
  std::optional<std::packaged_task<void()>> task_;
  std::optional<frame::FrameRenderer> renderer_;
  std::optional<frame::ViewState> view_;
  std::jthread thread_{[this](std::stop_token stop) { serve(std::move(stop)); }};
};

RenderRig::RenderRig(const BenchCase& bench_case, const frame::RendererSettings& settings,
                     const RigOptions& options)
    : case_(bench_case), worker_(std::make_unique<Worker>(bench_case, settings, options)) {
  first_milliseconds_ = render_milliseconds();
}

RenderRig::~RenderRig() = default;

frame::FrameOutput RenderRig::render() {
  return render(case_.input);
}

frame::FrameOutput RenderRig::render(const frame::FrameInput& input, frame::FrameBuffers* buffers) {
  return worker_->render(input, buffers);
}

void RenderRig::look_through(const common::CameraModel& camera, const RigOptions& options) {
  worker_->look_through(camera, options);
}

double RenderRig::render_milliseconds() {
  const core::Stopwatch stopwatch;
  render();
  return stopwatch.milliseconds();
}

double median_frame_milliseconds(RenderRig& rig, double seconds) {
  const double budget = 1000.0 * seconds;
  if (rig.first_milliseconds() > 3.0 * budget) return rig.first_milliseconds();
  const core::Stopwatch stopwatch;
  std::vector<double> times;
  constexpr std::size_t kEnough = 15;
  do {
    times.push_back(rig.render_milliseconds());
  } while (stopwatch.milliseconds() < budget && times.size() < kEnough);
  return median(times);
}

}  // namespace amalgam::bench
