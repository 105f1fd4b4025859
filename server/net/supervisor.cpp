#include "net/supervisor.h"

#include <systemd/sd-daemon.h>

#include <chrono>
#include <cstring>
#include <string>

#include "common/log.h"
#include "net/quietly.h"

namespace amalgam::net {
namespace {

std::string text_of(ServiceState state) {
  switch (state) {
    case ServiceState::Ready:
      return "READY=1";
    case ServiceState::Reloading: {
      // systemd compares the time with that of its own request (Type=notify-reload).
      const auto now = std::chrono::duration_cast<std::chrono::microseconds>(
          std::chrono::steady_clock::now().time_since_epoch());
      return "RELOADING=1\nMONOTONIC_USEC=" + std::to_string(now.count());
    }
    case ServiceState::Stopping:
      return "STOPPING=1";
    case ServiceState::Alive:
      return "WATCHDOG=1";
  }
  return "";
}

}  // namespace

void tell_supervisor(ServiceState state) {
  quietly([&] {
    const int result = ::sd_notify(0, text_of(state).c_str());
    if (result < 0) {
      common::log_warn(common::LogKind::Accept,
                       std::string("the service manager was not told: ") + std::strerror(-result));
    }
  });
}

}  // namespace amalgam::net
