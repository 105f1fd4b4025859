// The operator's settings for the network side: addresses, the token, and every limit that is not
// part of the message format. protocol/limits.h gives the defaults and their reasons.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

#include "common/host_port.h"
#include "protocol/limits.h"

namespace amalgam::net {

struct SessionLimits {
  std::chrono::milliseconds hello_timeout = protocol::kHelloTimeout;
  std::chrono::milliseconds message_timeout = protocol::kMessageTimeout;
  std::chrono::milliseconds rate_grace = protocol::kRateGrace;
  std::size_t min_bytes_per_second = protocol::kMinBytesPerSecond;
  std::chrono::milliseconds ping_interval = protocol::kPingInterval;
  std::chrono::milliseconds idle_timeout = protocol::kIdleTimeout;
  std::chrono::milliseconds write_timeout = protocol::kWriteTimeout;
  std::chrono::milliseconds linger = protocol::kLinger;
  std::chrono::milliseconds pose_hold = protocol::kPoseHold;
};

struct ConnectionCaps {
  std::size_t total = protocol::kMaxConnections;
  std::size_t unauthenticated = protocol::kMaxUnauthenticated;
  std::size_t per_address = protocol::kMaxPerAddress;
  std::size_t admin = protocol::kMaxAdminConnections;
};

struct ServerConfig {
  common::HostPort listen{"127.0.0.1", 7447};
  common::HostPort admin{"127.0.0.1", 7448};
  std::string token;       // a secret: never logged; empty: clients need none
  std::string ray_tracer;  // name and version, for the /state page
  SessionLimits session;
  ConnectionCaps connections;
  std::chrono::milliseconds drain_timeout = protocol::kDrainTimeout;
};

}  // namespace amalgam::net
