// What the reader has not read yet. Buffers of kernels and proxies hide whether anybody reads, so a
// ping follows each composite: its pong tells that everything up to it was read. All pongs together
// tell how long a composite takes on its way.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>

namespace amalgam::net {

class ReadPings {
 public:
  using Time = std::chrono::steady_clock::time_point;

  // The nonce of a ping that follows nothing, or a composite, written now.
  std::uint64_t next(Time now);
  std::uint64_t after_composite(Time now);
  void heard_pong(std::uint64_t nonce, Time now);

  // True if the next composite may be written. One on its way keeps a slow line busy, and what is
  // written behind it only grows old there. A second one is worth it where most of the way is
  // waiting for the pong: where a transfer takes less than the quickest round trip.
  bool may_write_composite() const;
  // When the oldest unread composite was written; nothing: all were read.
  std::optional<Time> unread_since() const;

 private:
  struct Ping {
    std::uint64_t nonce;
    Time written;
  };

  std::uint64_t last_ = 0;
  // Without a pong. Of those that follow nothing one is enough: a client that answers none, but
  // talks, stays.
  std::optional<Ping> alone_;
  std::deque<Ping> unread_;  // behind composites
  Time read_{};              // when the last composite was
  // Round trips without a transfer are known from other pings only.
  std::optional<Time::duration> quickest_, transfer_;
};

}  // namespace amalgam::net
