// One client's environments on their way to the renderer: one is being applied and one waits. A
// newer one replaces the waiting one, because applying takes longer than sending.
#pragma once

#include <optional>
#include <utility>

#include "frame/frame.h"

namespace amalgam::net {

class EnvironmentSlot {
 public:
  struct Offered {
    std::optional<frame::EnvironmentInput> now;  // to be applied at once
    bool replaced = false;                       // a waiting one will never be applied
  };
  Offered offer(frame::EnvironmentInput input) {
    if (!std::exchange(applying_, true)) return {.now = std::move(input), .replaced = false};
    const bool replaced = waiting_.has_value();
    waiting_ = std::move(input);
    return {.now = std::nullopt, .replaced = replaced};
  }

  // The one being applied is done. Returns the next, if there is one.
  std::optional<frame::EnvironmentInput> done() {
    applying_ = waiting_.has_value();
    return std::exchange(waiting_, std::nullopt);
  }

 private:
  bool applying_ = false;
  std::optional<frame::EnvironmentInput> waiting_;
};

}  // namespace amalgam::net
