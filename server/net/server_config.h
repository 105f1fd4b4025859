// The operator's settings for the network side: addresses, tokens, and every limit that is not part
// of the message format. protocol/limits.h gives the defaults and their reasons.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/host_port.h"
#include "frame/frame.h"
#include "net/access.h"
#include "protocol/limits.h"
#include "record/record_options.h"
#include "web/web_files.h"

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
  double environments_per_second = protocol::kEnvironmentsPerSecond;
};

struct ConnectionCaps {
  std::size_t total = protocol::kMaxConnections;
  std::size_t unauthenticated = protocol::kMaxUnauthenticated;
  std::size_t per_address = protocol::kMaxPerAddress;
  std::size_t admin = protocol::kMaxAdminConnections;
};

// How much is promised to sessions in all.
struct AdmissionLimits {
  // Part of the renderer's time that sessions may need together; 0: no limit.
  double load = protocol::kMaxLoad;
  // Bytes that sessions may need together; 0: no limit.
  std::uint64_t memory = protocol::kMaxSessionMemory;
};

struct TlsFiles {
  std::string certificate, key;  // PEM; both or none
};

// Makes the bytes of a file from the scene's markers. Called on a thread of its own. Throws
// std::runtime_error with a line for people if there cannot be one.
using MakeFile = std::function<std::string(const frame::FrameService::MarkerSet&)>;

// What browsers get at the web port.
struct WebOptions {
  std::span<const web::WebFile> files;  // of the page
  std::string folder;                   // where they are read instead; empty: nowhere
  // Files that are made when somebody first asks, by what is asked for, as
  // "/marker-sheet.pdf?paper=a4".
  std::map<std::string, MakeFile, std::less<>> made;
  // Whose pages may open sessions, as https://example.org:8443. Empty: the server's own page.
  std::vector<std::string> origins;
};

struct ServerConfig {
  common::HostPort listen{"127.0.0.1", 7447};
  common::HostPort admin{"127.0.0.1", 7448};
  std::span<const web::WebFile> status_files;  // of the page for operators, at the admin port
  bool admin_pictures = false;  // sessions' last composites are kept, for whoever reaches it
  std::optional<common::HostPort> agent;  // where a load balancer asks for the free capacity
  std::optional<common::HostPort> web;    // where browsers connect
  WebOptions web_options;
  std::vector<Grant> grants;  // empty: clients need no token
  EnvironmentFrom environment_from = EnvironmentFrom::Authorised;
  std::vector<std::string> trusted_proxies;  // unmapped addresses whose PROXY headers are believed
  TlsFiles tls;
  std::string ray_tracer;  // name and version, for the /state page
  SessionLimits session;
  ConnectionCaps connections;
  AdmissionLimits admission;
  record::RecordOptions record;
  // From SIGTERM until Draining, so that a load balancer notices before sessions look for another
  // server. New ones are still served.
  std::chrono::milliseconds drain_delay{0};
  std::chrono::milliseconds drain_timeout = protocol::kDrainTimeout;
  // /livez fails when the renderer has made no progress for this long with a frame or with an
  // environment for all ...
  std::chrono::milliseconds stuck_after = protocol::kStuckAfter;
  // ... or when a reload has stopped it for this long.
  std::chrono::milliseconds stuck_reload_after = protocol::kStuckReloadAfter;
};

}  // namespace amalgam::net
