#include "net/limits_in_use.h"

#include "net/process_figures.h"

namespace amalgam::net {

std::vector<ServerReport::Limit> limits_in_use(const ServerConfig& config,
                                               const ConnectionLimits& connections,
                                               const Admission& admission,
                                               const frame::ServiceLoad& load) {
  const ProcessFigures process = read_process_figures();
  const auto limit = [](const char* name, auto used, auto most) {
    return ServerReport::Limit{name, static_cast<double>(used), static_cast<double>(most)};
  };
  const ConnectionCaps& caps = config.connections;
  return {limit("connections", connections.total(), caps.total),
          limit("unauthenticated", connections.unauthenticated(), caps.unauthenticated),
          limit("load", load.demand, config.admission.load),
          limit("session_memory", admission.memory(), config.admission.memory),
          limit("descriptors", process.open_descriptors, process.most_descriptors)};
}

}  // namespace amalgam::net
