// A renderer without a thread: what it does next is said by the fuzzer.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "common/log.h"
#include "frame/frame.h"

namespace amalgam::fuzz {

class ScriptedService final : public frame::FrameService {
 public:
  frame::ViewId open_view(const frame::ViewOptions& options, Deliver deliver) override {
    const std::string defect = common::describe_defect(options.camera);
    AMALGAM_CHECK(defect.empty(), defect);
    views_.emplace(++last_view_, View{std::move(deliver), std::nullopt});
    return last_view_;
  }

  bool submit(frame::ViewId view, std::uint64_t ticket, frame::FrameInput input) override {
    AMALGAM_CHECK(views_.contains(view), "a frame of a closed view");
    for (const common::MarkerPose& pose : input.poses) {
      AMALGAM_CHECK(common::is_usable(pose), "marker " + std::to_string(pose.marker));
    }
    return std::exchange(views_.at(view).waiting, ticket).has_value();
  }

  void close_view(frame::ViewId view) override {
    AMALGAM_CHECK(views_.erase(view) == 1, "a view is closed that is not open");
  }

  void set_environment(frame::EnvironmentInput,
                       std::function<void(std::optional<std::string>)> done) override {
    environments_.push_back(std::move(done));
  }

  MarkerSet markers() const override { return {"DICT_6X6_250", 0.05, 40, {40, 23}}; }

  // The oldest view's frame is done, if it has one.
  void finish_frame(frame::FrameResult result) {
    if (views_.empty() || !views_.begin()->second.waiting) return;
    View& view = views_.begin()->second;
    view.deliver(*std::exchange(view.waiting, std::nullopt), std::move(result));
  }

  void finish_environment(std::optional<std::string> error) {
    if (environments_.empty()) return;
    const auto done = std::move(environments_.front());
    environments_.pop_front();
    done(std::move(error));
  }

  std::size_t open_views() const { return views_.size(); }

 private:
  struct View {
    Deliver deliver;
    std::optional<std::uint64_t> waiting;
  };
  std::map<frame::ViewId, View> views_;
  std::deque<std::function<void(std::optional<std::string>)>> environments_;
  frame::ViewId last_view_ = 0;
};

}  // namespace amalgam::fuzz
