#include "net/liveness.h"

namespace amalgam::net {

std::string why_not_alive(const frame::ServiceLoad& load, const ServerConfig& config) {
  const auto ms = [](std::chrono::milliseconds time) {
    return std::to_string(time.count()) + " ms";
  };
  if (load.without_progress >= config.stuck_after) {
    return "the renderer has made no progress for " + ms(load.without_progress);
  }
  if (load.reloading >= config.stuck_reload_after) {
    return "a new renderer has been under way for " + ms(load.reloading);
  }
  return "";
}

}  // namespace amalgam::net
