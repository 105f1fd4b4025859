#include "net/deadlines.h"

#include <algorithm>

namespace amalgam::net {

void Deadlines::authenticated(Time now) {
  authenticated_ = true;
  heard_ = now;
  pinged_ = now;
}

void Deadlines::received_message(Time now) {
  heard_ = now;
  message_begun_.reset();
}

void Deadlines::received_part(std::size_t bytes, Time now) {
  if (bytes > 0 && !message_begun_) message_begun_ = now;
  message_bytes_ = bytes;
}

std::optional<Deadlines::Passed> Deadlines::passed(Time now) const {
  if (!authenticated_) {
    // However slowly bytes arrive: only a complete hello counts.
    if (now - connected_ >= limits_.hello_timeout) return Passed::Hello;
    return std::nullopt;
  }
  if (write_begun_ && now - *write_begun_ >= limits_.write_timeout) return Passed::SlowReader;
  if (unread_since_ && now - *unread_since_ >= limits_.write_timeout) return Passed::SlowReader;
  if (too_slow(now)) return Passed::SlowSender;
  if (!message_begun_ && now - heard_ >= limits_.idle_timeout) return Passed::Idle;
  return std::nullopt;
}

bool Deadlines::too_slow(Time now) const {
  if (!message_begun_) return false;
  const auto elapsed = now - *message_begun_;
  if (elapsed >= limits_.message_timeout) return true;
  if (elapsed < limits_.rate_grace) return false;
  const double seconds = std::chrono::duration<double>(elapsed).count();
  return static_cast<double>(message_bytes_) <
         seconds * static_cast<double>(limits_.min_bytes_per_second);
}

bool Deadlines::ping_due(Time now) {
  if (!authenticated_ || now - pinged_ < limits_.ping_interval) return false;
  pinged_ = now;
  return true;
}

Deadlines::Time Deadlines::next() const {
  if (!authenticated_) return connected_ + limits_.hello_timeout;
  // The rate of a message is looked at with each ping, often enough for a limit of seconds.
  Time next = pinged_ + limits_.ping_interval;
  next = std::min(next, message_begun_ ? *message_begun_ + limits_.message_timeout
                                       : heard_ + limits_.idle_timeout);
  if (write_begun_) next = std::min(next, *write_begun_ + limits_.write_timeout);
  if (unread_since_) next = std::min(next, *unread_since_ + limits_.write_timeout);
  return next;
}

}  // namespace amalgam::net
