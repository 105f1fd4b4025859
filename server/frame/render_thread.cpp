#include "frame/render_thread.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "codec/jpeg.h"
#include "common/log.h"
#include "frame/environment_input.h"
#include "frame/scene_renderer.h"
#include "frame/view_state.h"

namespace amalgam::frame {
namespace {

std::size_t pixels_of(const ViewOptions& options) {
  return static_cast<std::size_t>(options.camera.width) *
         static_cast<std::size_t>(options.camera.height);
}

template <typename Step>
std::optional<std::string> error_of(const Step& step) {
  try {
    step();
    return std::nullopt;
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

struct RenderThread::View {
  View(ViewId view_id, const ViewOptions& view_options, Deliver deliver_to)
      : id(view_id), options(view_options), deliver(std::move(deliver_to)) {}

  struct Waiting {
    std::uint64_t ticket = 0;
    FrameInput input;
  };

  const ViewId id;
  const ViewOptions options;
  std::unique_ptr<ViewRenderer::State> state;  // used by the render thread only; made by a frame
  common::Mailbox<Waiting> mailbox;
  common::Mailbox<NewEnvironment> own_environment;
  // Used by the render thread only: the one that is applied, for the next renderer's state.
  std::optional<EnvironmentInput> own_applied;
  std::mutex delivering;
  bool closed = false;  // under delivering
  Deliver deliver;
};

RenderThread::RenderThread(const MakeRenderer& make) {
  std::promise<void> started;
  auto ready = started.get_future();
  thread_ = std::jthread(
      [this, &make, &started](const std::stop_token& stop) { run(stop, make, started); });
  ready.get();
}

RenderThread::RenderThread(const std::string& scene_path, const RenderServiceOptions& options)
    : RenderThread(renderer_of_file(scene_path, options.renderer)) {}

void RenderThread::stop() {
  thread_.request_stop();
  {
    // No frame begins after this: take_next_view() looks under the same lock.
    const std::lock_guard lock(mutex_);
    progress_.cancel();
  }
  if (thread_.joinable()) thread_.join();
}

ViewId RenderThread::open_view(const ViewOptions& options, Deliver deliver) {
  check_view(options);
  const std::lock_guard lock(mutex_);
  const ViewId id = ++last_id_;
  views_.emplace(id, std::make_shared<View>(id, options, std::move(deliver)));
  turns_.open(id, pixels_of(options));
  return id;
}

bool RenderThread::submit(ViewId id, std::uint64_t ticket, FrameInput input) {
  std::optional<View::Waiting> replaced;  // freed after the lock
  {
    const std::lock_guard lock(mutex_);
    const auto found = views_.find(id);
    if (found == views_.end()) return false;
    replaced = found->second->mailbox.put({ticket, std::move(input)});
    turns_.submitted(id, Clock::now());
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
    turns_.close(id);
    if (serving_ == id) progress_.cancel();
    const std::size_t pixels = pixels_of(view->options);
    if (std::ranges::none_of(views_, [&](const auto& other) {
          return pixels_of(other.second->options) >= pixels;
        })) {
      largest_closed_ = has_other_ = true;
    }
  }
  work_.notify_one();
  const std::lock_guard lock(view->delivering);
  view->closed = true;
}

void RenderThread::set_environment(EnvironmentInput input, Done done) {
  std::optional<NewEnvironment> replaced;
  {
    const std::lock_guard lock(mutex_);
    NewEnvironment wanted{std::move(input), std::move(done)};
    if (const auto view = wanted.input.only_for) {
      const auto found = views_.find(*view);
      if (found == views_.end()) return;
      replaced = found->second->own_environment.put(std::move(wanted));
    } else {
      replaced = environment_.put(std::move(wanted));
      has_other_ = true;
    }
  }
  work_.notify_one();
  if (replaced) replaced->done("replaced by a newer environment before it was used");
}

std::uint64_t RenderThread::memory_of(const EnvironmentInput& input) const {
  return environment_bytes(input);
}

void RenderThread::replace_renderer(MakeRenderer make, Done done) {
  const auto replaced = renderer_to_be_.put({std::move(make), std::move(done)});
  {
    const std::lock_guard lock(mutex_);
    has_other_ = true;
  }
  work_.notify_one();
  if (replaced) replaced->done("replaced by a newer one before it was used");
}

FrameService::MarkerSet RenderThread::markers() const {
  const std::lock_guard lock(mutex_);
  return markers_;
}

FrameService::Fingerprint RenderThread::fingerprint() const {
  const std::lock_guard lock(mutex_);
  return fingerprint_;
}

ServiceLoad RenderThread::load() const {
  const auto milliseconds_since = [now = Clock::now()](Clock::time_point time) {
    return std::chrono::duration_cast<std::chrono::milliseconds>(now - time);
  };
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  ServiceLoad load{.demand = turns_.demand(now),
                   .seconds_per_pixel = turns_.seconds_per_pixel(),
                   .frames_per_second = turns_.mean_rate(now)};
  if (const auto oldest = turns_.oldest_waiting()) load.queue_age = milliseconds_since(*oldest);
  if (const std::uint64_t steps = progress_.steps(); steps != std::exchange(steps_seen_, steps)) {
    progress_seen_ = now;
  }
  if (working_) load.without_progress = milliseconds_since(progress_seen_);
  if (reload_begun_) load.reloading = milliseconds_since(*reload_begun_);
  return load;
}

// --- on the render thread ---

void RenderThread::run(const std::stop_token& stop, const MakeRenderer& make,
                       std::promise<void>& started) {
  try {
    adopt(make());
    started.set_value();
  } catch (...) {
    renderer_.reset();
    started.set_exception(std::current_exception());
    return;
  }
  // The constructor has returned: from here on neither make nor the promise may be used.
  while (wait_for_work(stop)) {
    apply_renderer();
    apply_environment();
    free_targets();
    if (const auto view = take_next_view(stop)) serve(*view);
  }
  // Views are freed where their states were made.
  const std::lock_guard lock(mutex_);
  views_.clear();
  renderer_.reset();
}

bool RenderThread::has_work(Clock::time_point now) const {
  return has_other_ || turns_.any_ready(now);
}

bool RenderThread::wait_for_work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  for (;;) {
    const auto now = Clock::now();
    if (stop.stop_requested()) return false;
    if (has_work(now)) break;
    const auto until = turns_.withheld_until(now);
    // A frame that comes meanwhile may be withheld too.
    const auto ready = [&] {
      const auto then = Clock::now();
      return has_work(then) || turns_.withheld_until(then) != until;
    };
    until ? work_.wait_until(lock, stop, *until, ready) : work_.wait(lock, stop, ready);
  }
  has_other_ = false;
  return true;
}

void RenderThread::begin_work() {
  working_ = true;
  progress_seen_ = Clock::now();
}

void RenderThread::apply_renderer() {
  auto wanted = renderer_to_be_.take();
  if (!wanted) return;
  {
    const std::lock_guard lock(mutex_);
    reload_begun_ = Clock::now();
  }
  const auto error = error_of([&] { adopt(wanted->make()); });
  if (error) renderer_->stay();
  {
    const std::lock_guard lock(mutex_);
    reload_begun_.reset();
  }
  wanted->done(error);
}

void RenderThread::adopt(std::unique_ptr<ViewRenderer> renderer) {
  MarkerSet markers = renderer->markers();
  Fingerprint fingerprint = renderer->fingerprint();
  Views views;
  {
    const std::lock_guard lock(mutex_);
    views = views_;
    markers_ = std::move(markers);
    fingerprint_ = std::move(fingerprint);
    turns_.assume_seconds_per_pixel(renderer->seconds_per_pixel());
  }
  if (renderer_) renderer_->stay();  // while what it made is freed
  for (const auto& [id, view] : views) view->state.reset();
  renderer_ = std::move(renderer);
  renderer_->stay();
}

void RenderThread::apply_environment() {
  auto update = environment_.take();
  if (!update) return;
  {
    const std::lock_guard lock(mutex_);
    begin_work();
  }
  const auto error = error_of([&] { renderer_->set_environment(update->input); });
  {
    const std::lock_guard lock(mutex_);
    working_ = false;
  }
  update->done(error);
}

void RenderThread::free_targets() {
  {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(largest_closed_, false)) return;
  }
  renderer_->free_targets();
}

std::shared_ptr<RenderThread::View> RenderThread::take_next_view(const std::stop_token& stop) {
  const std::lock_guard lock(mutex_);
  if (stop.stop_requested()) return nullptr;
  const auto next = turns_.next(Clock::now());
  if (!next) return nullptr;
  serving_ = *next;
  begin_work();
  progress_.begin();
  return views_.at(*next);
}

void RenderThread::serve(View& view) {
  auto waiting = view.mailbox.take();
  AMALGAM_CHECK(waiting.has_value(), "a turn for a view without a frame");
  const Clock::time_point begin = Clock::now();
  FrameResult result = render(view, waiting->input);
  {
    const std::lock_guard lock(mutex_);
    const Clock::time_point end = Clock::now();
    turns_.served(view.id, end - begin, end);
    serving_ = 0;
    working_ = false;
  }
  const std::lock_guard lock(view.delivering);
  if (!view.closed) view.deliver(waiting->ticket, std::move(result));
}

// With a frame, and so in the view's turn: whoever sends many pays with its own frames.
void RenderThread::apply_own_environment(View& view) {
  auto update = view.own_environment.take();
  if (!update) return;
  const auto error = error_of([&] { renderer_->set_own_environment(*view.state, update->input); });
  if (!error) view.own_applied = std::move(update->input);
  update->done(error);
}

FrameResult RenderThread::render(View& view, FrameInput& input) {
  try {
    input.progress = &progress_;
    if (!view.state) {
      view.state = renderer_->open(view.options);
      if (view.own_applied) renderer_->set_own_environment(*view.state, *view.own_applied);
    }
    apply_own_environment(view);
    return renderer_->render(*view.state, input);
  } catch (const codec::JpegError& error) {
    return FrameFailure{FrameFailure::Kind::BadImage, error.what()};
  } catch (const std::exception& error) {
    // Told to the session, which knows whose frame it is.
    return FrameFailure{FrameFailure::Kind::Internal, error.what()};
  }
}

}  // namespace amalgam::frame
