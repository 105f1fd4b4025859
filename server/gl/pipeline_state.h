// The fixed-function state that a pass draws with, set as a whole, so that no pass depends on what
// the one before it left behind.
#pragma once

#include <cstdint>

namespace amalgam::gl {

struct PipelineState {
  // Depth is reversed: nearer is greater.
  enum class Depth : std::uint8_t {
    Off,
    NearestWrites,  // the nearest surface wins and is kept
    EqualReads,     // only what an earlier pass found to be nearest; nothing is written
  };
  enum class Blend : std::uint8_t {
    Off,
    AddColorKeepNearest,  // RGB adds up, alpha keeps the maximum
  };
  Depth depth = Depth::Off;
  Blend blend = Blend::Off;
  bool push_depth_away = false;  // polygon offset, for shadow maps
};

// Also what never changes: zero-to-one depth, both sides of faces drawn, no clear restricted by
// masks.
void apply(const PipelineState& state);

}  // namespace amalgam::gl
