// What a session may still have to write: short control messages in order, and at most one
// composite that waits while another is being written. A newer composite replaces the one that
// waits, because a mixed-reality viewer wants the present and not a queue. Knows nothing of
// sockets.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "protocol/amalgam.pb.h"

namespace amalgam::net {

class WriteSlot {
 public:
  explicit WriteSlot(std::size_t max_control) : max_control_(max_control) {}

  // False if so many control messages wait already that this one is dropped.
  bool put_control(const protocol::Envelope& message);

  // True if a composite that waited has been replaced and will never be written.
  bool put_composite(protocol::Composite composite);

  // The next message, if there is one and no write is in flight; after it a write is in flight.
  // Control goes first: it is small, and an Error should not wait behind an image. `skipped` goes
  // into a composite only now, so that it counts what was replaced while waiting.
  std::optional<std::string> begin_write(std::uint64_t skipped);
  void end_write() { writing_ = Writing::Nothing; }

  // Drops the control messages that wait: room for a last Error, which nothing must keep out.
  void drop_control() { control_.clear(); }
  // Drops the composite that waits; true if there was one.
  bool drop_composite();

  bool writing() const { return writing_ != Writing::Nothing; }
  bool writing_composite() const { return writing_ == Writing::Composite; }
  bool empty() const { return !writing() && control_.empty() && !composite_; }

 private:
  enum class Writing { Nothing, Control, Composite };

  std::size_t max_control_;
  std::deque<std::string> control_;
  std::optional<protocol::Composite> composite_;
  Writing writing_ = Writing::Nothing;
};

}  // namespace amalgam::net
