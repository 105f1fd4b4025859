// Whether the renderer still gets somewhere: what /livez answers and the watchdog is fed by.
#pragma once

#include <string>

#include "frame/frame.h"
#include "net/server_config.h"

namespace amalgam::net {

// A line for people; empty: alive.
std::string why_not_alive(const frame::ServiceLoad& load, const ServerConfig& config);

}  // namespace amalgam::net
