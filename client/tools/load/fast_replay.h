// Plays what the renderer did, as fast as it does it again: the next frame is sent when the last
// one is answered, so that none is skipped.
//
// Left out is what decided no composite: frames that a newer one replaced, and lights that were
// refused or replaced. The poses are those that the renderer was given. Solving corners, smoothing
// and holding depend on when frames came, and are part of them already; a TimedReplay has them
// again.
#pragma once

#include <cstddef>
#include <map>

#include "client/tools/load/replay.h"
#include "common/rate_limit.h"

namespace amalgam::load {

class FastReplay : public Replay {
 public:
  FastReplay(boost::asio::io_context& io, const LoadOptions& options,
             const RecordedSession& session, ReplayComparison& comparison);

 private:
  void begin() override { next(); }
  void answered(std::uint64_t number) override;

  void next();
  Clock::time_point when_unheld(const protocol::CameraFrame& frame) const;

  std::vector<RecordedSession::Turn> turns_;
  std::size_t turn_ = 0;
  bool light_sent_ = false;  // of this turn
  common::RateLimit lights_;
  std::map<int, Clock::time_point> seen_;  // markers: the last answer to a frame with them
};

}  // namespace amalgam::load
