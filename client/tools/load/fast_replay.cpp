#include "client/tools/load/fast_replay.h"

#include <algorithm>
#include <utility>

#include "protocol/limits.h"

namespace amalgam::load {
namespace {

// A little below what servers allow, because messages may come closer together than they were sent.
constexpr double kLightsPerSecond = 0.9 * protocol::kEnvironmentsPerSecond;
constexpr std::chrono::milliseconds kPause{100};

}  // namespace

FastReplay::FastReplay(boost::asio::io_context& io, const LoadOptions& options,
                       const RecordedSession& session, ReplayComparison& comparison)
    : Replay(io, options, session, comparison),
      turns_(session.turns),
      lights_(protocol::kEnvironmentBurst, kLightsPerSecond) {
  // Nothing to compare with, but it may do again what it did.
  if (session.unfinished) turns_.push_back(*session.unfinished);
}

void FastReplay::next() {
  if (turn_ == turns_.size()) return finish();
  const RecordedSession::Turn& turn = turns_[turn_];
  const auto now = Clock::now();
  if (turn.light && !light_sent_) {
    if (!lights_.admit(now)) return wait_until(now + kPause, [this] { next(); });
    light_sent_ = true;
    send(session().lights[*turn.light]);
  }
  const RecordedFrame& recorded = session().frames[turn.frame];
  protocol::CameraFrame frame = recorded.as_submitted();
  if (const auto time = when_unheld(frame); time > now) {
    return wait_until(time, [this] { next(); });
  }
  send(recorded.number, std::move(frame));
  wait_until(now + kPatience, [this] {
    comparison().remark("a frame got no answer");
    finish();
  });
}

// The server adds the last poses of markers that have just been seen. Where a frame was rendered
// without such a marker, that time had passed.
Replay::Clock::time_point FastReplay::when_unheld(const protocol::CameraFrame& frame) const {
  Clock::time_point time{};
  for (const auto& [marker, seen] : seen_) {
    const bool is_there = std::ranges::any_of(
        frame.poses(), [&](const protocol::Pose& pose) { return pose.marker() == marker; });
    if (!is_there) time = std::max(time, seen + protocol::kPoseHold + std::chrono::milliseconds(1));
  }
  return time;
}

void FastReplay::answered(std::uint64_t number) {
  if (turn_ == turns_.size()) return;
  const RecordedFrame& frame = session().frames[turns_[turn_].frame];
  if (number != frame.number) return;
  for (const protocol::Pose& pose : frame.poses()) seen_[pose.marker()] = Clock::now();
  ++turn_;
  light_sent_ = false;
  next();
}

}  // namespace amalgam::load
