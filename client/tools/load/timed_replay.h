// Plays what the client sent, when it did. The renderer may be faster or slower than it was, and so
// skip other frames: composites are compared where both sessions have one. The metered exposure
// follows the frames that were rendered, so a frame skipped in one of them may change the next
// ones' bytes a little, too.
#pragma once

#include <cstddef>
#include <vector>

#include "client/tools/load/replay.h"

namespace amalgam::load {

class TimedReplay : public Replay {
 public:
  TimedReplay(boost::asio::io_context& io, const LoadOptions& options,
              const RecordedSession& session, ReplayComparison& comparison);

 private:
  struct Event {
    std::chrono::microseconds time{0};
    bool is_light = false;
    std::size_t index = 0;
  };

  void begin() override;
  void answered(std::uint64_t number) override;
  void next();

  std::vector<Event> events_;  // by time
  std::size_t event_ = 0;
  Clock::time_point begin_{};
  std::uint64_t last_sent_ = 0, last_answered_ = 0;
};

}  // namespace amalgam::load
