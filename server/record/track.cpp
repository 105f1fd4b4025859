#include "record/track.h"

namespace amalgam::record {

const char* to_string(Fate fate) {
  switch (fate) {
    case Fate::Off:
      return "off";
    case Fate::On:
      return "on";
    case Fate::Closed:
      return "closed";
    case Fate::Full:
      return "full";
    case Fate::TooSlow:
      return "too_slow";
    case Fate::Failed:
      return "failed";
    case Fate::Reloaded:
      return "reloaded";
  }
  return "";
}

protocol::SessionRecord record_now(const Track& track) {
  const auto time =
      std::chrono::duration_cast<std::chrono::microseconds>(Track::Clock::now() - track.begin);
  protocol::SessionRecord record;
  record.set_time_us(static_cast<std::uint64_t>(time.count()));
  return record;
}

}  // namespace amalgam::record
