#include "client/tools/load/timed_replay.h"

#include <algorithm>

namespace amalgam::load {

TimedReplay::TimedReplay(boost::asio::io_context& io, const LoadOptions& options,
                         const RecordedSession& session, ReplayComparison& comparison)
    : Replay(io, options, session, comparison) {
  for (std::size_t i = 0; i < session.lights.size(); ++i) {
    events_.push_back({session.lights[i].time, true, i});
  }
  for (std::size_t i = 0; i < session.frames.size(); ++i) {
    events_.push_back({session.frames[i].time, false, i});
  }
  std::ranges::stable_sort(events_, {}, &Event::time);  // light before the frame that came with it
}

void TimedReplay::begin() {
  begin_ = Clock::now();
  next();
}

void TimedReplay::next() {
  for (; event_ < events_.size(); ++event_) {
    const Event& event = events_[event_];
    if (const auto due = begin_ + event.time; due > Clock::now()) {
      return wait_until(due, [this] { next(); });
    }
    if (event.is_light) {
      send(session().lights[event.index]);
    } else {
      const RecordedFrame& frame = session().frames[event.index];
      last_sent_ = frame.number;
      send(frame.number, frame.message);
    }
  }
  // The newest frame wins, so the last one is answered.
  if (last_answered_ >= last_sent_) return finish();
  wait_until(Clock::now() + kPatience, [this] {
    comparison().remark("the last frame got no answer");
    finish();
  });
}

void TimedReplay::answered(std::uint64_t number) {
  last_answered_ = std::max(last_answered_, number);
  if (event_ == events_.size() && last_answered_ >= last_sent_) finish();
}

}  // namespace amalgam::load
