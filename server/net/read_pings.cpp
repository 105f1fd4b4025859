#include "net/read_pings.h"

#include <algorithm>

#include "protocol/limits.h"

namespace amalgam::net {

std::uint64_t ReadPings::add(bool after_composite, Time now) {
  unheard_.push_back({++last_, now, after_composite});
  return last_;
}

void ReadPings::heard_pong(std::uint64_t nonce, Time now) {
  while (!unheard_.empty() && unheard_.front().nonce <= nonce) {
    const Ping ping = unheard_.front();
    unheard_.pop_front();
    // Pongs that were left out were not timed.
    if (ping.nonce != nonce) continue;
    const auto round_trip = now - ping.written;
    if (!ping.after_composite || quickest_) {
      quickest_ = std::min(quickest_.value_or(round_trip), round_trip);
    }
    if (!ping.after_composite) continue;
    // Behind another composite its transfer began when that one had been read.
    if (quickest_) transfer_ = std::min(round_trip - *quickest_, now - read_);
    read_ = now;
  }
}

bool ReadPings::may_write_composite() const {
  const auto unread = std::ranges::count_if(unheard_, &Ping::after_composite);
  if (unread == 0) return true;
  return unread < protocol::kMaxUnreadComposites && transfer_ && *transfer_ < *quickest_;
}

std::optional<ReadPings::Time> ReadPings::unread_since() const {
  const auto oldest = std::ranges::find_if(unheard_, &Ping::after_composite);
  return oldest == unheard_.end() ? std::nullopt : std::optional(oldest->written);
}

}  // namespace amalgam::net
