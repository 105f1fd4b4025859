// Tells the service manager how the server is: systemd, or whoever else set NOTIFY_SOCKET
// (sd_notify(3)). Where nobody did, nothing happens.
#pragma once

namespace amalgam::net {

enum class ServiceState {
  Ready,      // serves, or serves again after a reload
  Reloading,  // until Ready
  Stopping,   // the process ends soon; nobody should wonder
  Alive,      // for the watchdog, which restarts a service that stays silent
};

// On the network thread. Never waits.
void tell_supervisor(ServiceState state);

}  // namespace amalgam::net
