// The operator's limits and how near they are, for the /state page.
#pragma once

#include <vector>

#include "net/admission.h"
#include "net/connection_limits.h"
#include "net/server_config.h"
#include "net/state_page.h"

namespace amalgam::net {

// load: in units of the renderer's time. session_memory: bytes.
std::vector<ServerReport::Limit> limits_in_use(const ServerConfig& config,
                                               const ConnectionLimits& connections,
                                               const Admission& admission,
                                               const frame::ServiceLoad& load);

}  // namespace amalgam::net
