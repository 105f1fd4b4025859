// The fixed-function state of a pass, set as a whole, so that no pass depends on the state that an
// earlier one left.
#pragma once

#include <cstdint>

namespace amalgam::gl {

struct PipelineState {
  // Depth is reversed: nearer is greater.
  enum class Depth : std::uint8_t {
    Off,
    NearestWrites,  // the nearest surface wins and is kept
    EqualReads,     // only the surface that an earlier pass found nearest; depth is not written
  };
  enum class Blend : std::uint8_t {
    Off,
    AddColorKeepNearest,  // RGB adds up, alpha keeps the maximum
  };
  Depth depth = Depth::Off;
  Blend blend = Blend::Off;
  bool push_depth_away = false;  // polygon offset, for shadow maps
};

// Also sets the constant state: depth from zero to one, both sides of faces drawn, no masks on
// clears.
void apply(const PipelineState& state);

}  // namespace amalgam::gl
