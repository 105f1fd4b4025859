// amalgam-load --replay.
#pragma once

#include <string>

#include "client/tools/load/load_options.h"

namespace amalgam::load {

struct ReplayOutcome {
  bool good =
      false;  // everything that was compared is equal, and nothing that should be is missing
  std::string json;
};

// Throws std::runtime_error if the record cannot be read.
ReplayOutcome run_replay(const LoadOptions& options);

}  // namespace amalgam::load
