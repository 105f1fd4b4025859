// What one session's frames were like of late, for people who look at it: how often they came and
// were answered, how long they took, what was done for the last one and what was left out.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "frame/frame.h"
#include "net/event_rate.h"
#include "net/session_report.h"

namespace amalgam::net {

class SessionFigures {
 public:
  using Time = EventRate::Time;

  void received(Time now) { asked_.happened(now); }
  void sent(Time now) { served_.happened(now); }
  // server_ms: from the last byte of the frame to its composite, waiting included.
  void rendered(const frame::FrameOutput& output, double server_ms);
  void fill(SessionReport& report, Time now) const;

 private:
  EventRate asked_, served_;
  std::array<float, 256> server_ms_{};  // of the last frames, by their number
  std::uint64_t rendered_ = 0, unchanged_ = 0;
  core::StageTimes stages_;  // of the last frame, as all that follows
  std::vector<frame::PassRecord> passes_;
  std::optional<frame::FrameQuality> quality_;
};

}  // namespace amalgam::net
