// What the /state page says of one session. The comments give the fields' names there, where those
// are not the same.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "net/metrics.h"

namespace amalgam::net {

struct SessionReport {
  std::uint64_t id = 0;
  std::string peer;             // address and port
  std::string transport;        // tcp, websocket
  std::string state;            // awaiting_hello, running, draining, closing
  std::chrono::seconds age{0};  // age_s, since its connection
  int width = 0, height = 0;    // pixels
  // frames_received, frames_sent, frames_skipped, frames_in_flight, frames_unchanged
  std::uint64_t received = 0, sent = 0, skipped = 0;
  std::size_t in_flight = 0;
  std::uint64_t unchanged = 0;  // of those rendered: nothing virtual had an effect
  std::array<std::uint64_t, kSkips.size()> skipped_by{};  // by the reasons' names
  // Over the last five seconds.
  double frames_asked_per_second = 0.0, frames_served_per_second = 0.0;
  std::uint64_t bytes_received = 0, bytes_sent = 0;  // of frames and of composites
  // server_ms_median, server_ms_p99: of the last 256 frames, from the last byte to the composite,
  // with waiting; none: there were none.
  struct ServerTime {
    double median = 0.0, p99 = 0.0;
  };
  std::optional<ServerTime> server_ms;
  // Of the last frame: stages_ms by name; passes with name, ran and reason; quality with level,
  // lowest_level and bound, only with a target frame rate.
  core::StageTimes stages;
  std::vector<frame::PassRecord> passes;
  std::optional<frame::FrameQuality> quality;
  bool own_environment = false;
  std::string record;              // what became of its record (record/track.h)
  std::uint64_t record_bytes = 0;  // written
  bool picture = false;            // whether /pictures/ID.jpg is there
};

}  // namespace amalgam::net
