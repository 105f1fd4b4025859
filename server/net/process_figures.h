// What the operating system says of this process, for metrics and for the /state page.
#pragma once

#include <cstdint>

namespace amalgam::net {

struct ProcessFigures {
  double cpu_seconds = 0.0;  // user and system, so far
  std::uint64_t resident_bytes = 0;
  std::uint64_t open_descriptors = 0;
  std::uint64_t most_descriptors = 0;  // that it may open; 0: as many as it likes
};

// 0 for what cannot be read.
ProcessFigures read_process_figures();

}  // namespace amalgam::net
