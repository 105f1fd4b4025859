#include "net/read_pings.h"

#include <algorithm>
#include <utility>

#include "protocol/limits.h"

namespace amalgam::net {

std::uint64_t ReadPings::next(Time now) {
  ++last_;
  if (!alone_) alone_ = Ping{last_, now};
  return last_;
}

std::uint64_t ReadPings::after_composite(Time now) {
  unread_.push_back({++last_, now});
  return last_;
}

// Only the ping that is answered was timed, and not those before it, whose pongs were left out.
void ReadPings::heard_pong(std::uint64_t nonce, Time now) {
  if (alone_ && alone_->nonce <= nonce) {
    const Ping ping = *std::exchange(alone_, std::nullopt);
    const auto round_trip = now - ping.written;
    if (ping.nonce == nonce) quickest_ = std::min(quickest_.value_or(round_trip), round_trip);
  }
  while (!unread_.empty() && unread_.front().nonce <= nonce) {
    const Ping ping = unread_.front();
    unread_.pop_front();
    if (ping.nonce != nonce) continue;
    const auto round_trip = now - ping.written;
    if (quickest_) {
      quickest_ = std::min(*quickest_, round_trip);
      // Behind another composite its transfer began when that one had been read.
      transfer_ = std::min(round_trip - *quickest_, now - read_);
    }
    read_ = now;
  }
}

bool ReadPings::may_write_composite() const {
  if (unread_.empty()) return true;
  return unread_.size() < protocol::kMaxUnreadComposites && transfer_ && *transfer_ < *quickest_;
}

std::optional<ReadPings::Time> ReadPings::unread_since() const {
  return unread_.empty() ? std::nullopt : std::optional(unread_.front().written);
}

}  // namespace amalgam::net
