// A FrameService without a renderer, for tests of the network: returns the client's JPEG, on a
// thread of its own, and can be held in the middle of a frame.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "frame/frame.h"

namespace amalgam::test {

// "JPEGs" that make the stub fail as the renderer would.
inline constexpr std::string_view kBadJpeg = "bad image";
inline constexpr std::string_view kCrashJpeg = "crash";

class StubFrameService final : public frame::FrameService {
 public:
  StubFrameService() : renderer_([this] { render_frames(); }) {}

  ~StubFrameService() override {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    changed_.notify_all();
    renderer_.join();
  }

  frame::ViewId open_view(const frame::ViewOptions& options, Deliver deliver) override {
    if (!common::describe_defect(options.camera).empty()) throw std::invalid_argument("camera");
    const std::lock_guard lock(mutex_);
    views_.emplace(++last_view_, View{std::move(deliver), std::nullopt});
    ++opened_;
    return last_view_;
  }

  bool submit(frame::ViewId id, std::uint64_t frame_id, frame::FrameInput input) override {
    bool replaced = false;
    {
      const std::lock_guard lock(mutex_);
      std::optional<Frame>& waiting = views_.at(id).waiting;
      replaced = waiting.has_value();
      waiting = Frame{frame_id, std::move(input)};
      ++submitted_;
    }
    changed_.notify_all();
    return replaced;
  }

  void close_view(frame::ViewId id) override {
    const std::lock_guard lock(mutex_);
    views_.erase(id);
    changed_.notify_all();
  }

  // Done at once unless held; a bad or crashing "JPEG" is answered as the renderer would.
  void set_environment(frame::EnvironmentInput input,
                       std::function<void(std::optional<std::string> error)> done) override {
    std::unique_lock lock(mutex_);
    environments_.push_back(std::move(input));
    environments_done_.push_back(std::move(done));
    changed_.notify_all();
  }

  std::uint64_t memory_of(const frame::EnvironmentInput& input) const override {
    return input.image.size();
  }

  MarkerSet markers() const override { return {"DICT_6X6_250", 0.05, 40, {40, 23}}; }

  frame::ServiceLoad load() const override {
    const std::lock_guard lock(mutex_);
    return load_;
  }
  void set_load(const frame::ServiceLoad& load) {
    const std::lock_guard lock(mutex_);
    load_ = load;
  }

  // How long each frame takes from now on, without using a processor.
  void set_cost(std::chrono::milliseconds cost) {
    const std::lock_guard lock(mutex_);
    cost_ = cost;
  }

  // From here on frames are taken but not finished, until release().
  void hold() {
    const std::lock_guard lock(mutex_);
    held_ = true;
  }
  void release() {
    {
      const std::lock_guard lock(mutex_);
      held_ = false;
    }
    changed_.notify_all();
  }

  // Waits until that many frames were submitted, taken, or views are open. False after ten seconds.
  bool wait_submitted(std::size_t count) {
    return wait([&] { return submitted_ >= count; });
  }
  bool wait_taken(std::size_t count) {
    return wait([&] { return taken_ >= count; });
  }
  bool wait_views(std::size_t count, std::chrono::milliseconds time = std::chrono::seconds(10)) {
    return wait([&] { return views_.size() == count; }, time);
  }
  bool wait_environments(std::size_t count) {
    return wait([&] { return environments_.size() >= count; });
  }
  std::vector<frame::EnvironmentInput> environments() const {
    const std::lock_guard lock(mutex_);
    return environments_;
  }
  std::size_t opened() const {
    const std::lock_guard lock(mutex_);
    return opened_;
  }

 private:
  struct Frame {
    std::uint64_t id;
    frame::FrameInput input;
  };
  struct View {
    Deliver deliver;
    std::optional<Frame> waiting;
  };

  template <typename Condition>
  bool wait(Condition condition, std::chrono::milliseconds time = std::chrono::seconds(10)) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, time, condition);
  }

  void render_frames() {
    std::unique_lock lock(mutex_);
    while (!ending_) {
      if (!environments_done_.empty() && !held_) {
        // The oldest one still to be answered.
        const frame::Bytes& image =
            environments_[environments_.size() - environments_done_.size()].image;
        const auto done = std::move(environments_done_.front());
        environments_done_.pop_front();
        done(text_of(image) == kBadJpeg ? std::optional<std::string>("not a JPEG") : std::nullopt);
        continue;
      }
      const auto view = std::find_if(views_.begin(), views_.end(), [](const auto& entry) {
        return entry.second.waiting.has_value();
      });
      if (view == views_.end()) {
        changed_.wait(lock);
        continue;
      }
      const frame::ViewId id = view->first;
      const Frame frame = *std::exchange(view->second.waiting, std::nullopt);
      ++taken_;
      changed_.notify_all();
      changed_.wait(lock, [&] { return !held_ || ending_; });
      changed_.wait_for(lock, cost_, [&] { return ending_; });
      const auto still_open = views_.find(id);
      if (still_open != views_.end()) still_open->second.deliver(frame.id, render(frame.input));
    }
  }

  static std::string_view text_of(const frame::Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  static frame::FrameResult render(const frame::FrameInput& input) {
    const auto& bytes = std::get<frame::Bytes>(input.image);
    const std::string_view text = text_of(bytes);
    if (text == kBadJpeg) {
      return frame::FrameFailure{frame::FrameFailure::Kind::BadImage, "not a JPEG"};
    }
    if (text == kCrashJpeg) {
      return frame::FrameFailure{frame::FrameFailure::Kind::Internal, "secret detail"};
    }
    frame::FrameOutput output;
    output.jpeg = bytes;
    output.unchanged = input.poses.empty();
    output.statistics.stages = {{"trace", 1.5}};
    output.statistics.passes = {{"composite", true, ""}, {"warp", false, "no lens distortion"}};
    output.statistics.rays.primary = 7;
    output.statistics.pixels = {.virtual_pixels = 10, .specular = 5, .refined = 0, .total = 100};
    return output;
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<frame::ViewId, View> views_;
  std::vector<frame::EnvironmentInput> environments_;
  std::deque<std::function<void(std::optional<std::string>)>> environments_done_;
  frame::ServiceLoad load_;
  frame::ViewId last_view_ = 0;
  std::size_t opened_ = 0, submitted_ = 0, taken_ = 0;
  bool held_ = false, ending_ = false;
  std::chrono::milliseconds cost_{0};
  std::thread renderer_;  // last: begins when everything else is there
};

}  // namespace amalgam::test
