// All time-outs of one session, independent of sockets and clocks. Takes events with their times;
// tells which time-out has passed and when to check again.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

#include "net/server_config.h"

namespace amalgam::net {

class Deadlines {
 public:
  using Time = std::chrono::steady_clock::time_point;
  enum class Passed { Hello, SlowSender, SlowReader, Idle };

  Deadlines(const SessionLimits& limits, Time now)
      : limits_(limits), connected_(now), heard_(now) {}

  // A client that was served something else first gets its time for the hello anew.
  void served(Time now) { connected_ = now; }
  // The hello was accepted: from now on the client is pinged and must be heard.
  void authenticated(Time now);
  void received_message(Time now);
  // After each read. bytes: received of the next message; 0: it has not begun.
  void received_part(std::size_t bytes, Time now);
  void write_begun(Time now) { write_begun_ = now; }
  void write_ended() { write_begun_.reset(); }
  // The oldest composite that is not known to be read was written then; nothing: all are read.
  void unread_since(std::optional<Time> time) { unread_since_ = time; }

  std::optional<Passed> passed(Time now) const;

  // True once for each interval that has passed; the caller then pings.
  bool ping_due(Time now);

  // The latest time to call passed() and ping_due() again.
  Time next() const;

 private:
  bool too_slow(Time now) const;

  SessionLimits limits_;
  Time connected_;
  bool authenticated_ = false;
  Time heard_;
  Time pinged_{};
  std::optional<Time> message_begun_;
  std::size_t message_bytes_ = 0;
  std::optional<Time> write_begun_;
  std::optional<Time> unread_since_;
};

}  // namespace amalgam::net
