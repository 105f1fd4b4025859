// A rendered frame on its way to the client: all that a Composite is filled from, but for the count
// of skipped frames, which is known when it is written.
#pragma once

#include "frame/frame.h"
#include "net/frame_ledger.h"

namespace amalgam::net {

struct Answer {
  FrameLedger::Entry frame;
  frame::FrameOutput output;
  double server_ms = 0.0;  // from the frame's last byte to its composite, waiting included
};

}  // namespace amalgam::net
