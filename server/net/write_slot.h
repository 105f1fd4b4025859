// A session's output: a queue of short control messages, and at most one composite that waits while
// another is being written. A newer composite replaces the waiting one, because a mixed-reality
// viewer wants the present and not a queue. Independent of sockets.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "net/answer.h"
#include "protocol/amalgam.pb.h"

namespace amalgam::net {

class WriteSlot {
 public:
  explicit WriteSlot(std::size_t max_control) : max_control_(max_control) {}

  // False if the queue is full and the message is dropped.
  bool put_control(const protocol::Envelope& message);

  // True if a waiting composite has been replaced and will never be written.
  bool put_answer(Answer answer);

  // Takes the next message, if there is one and no write is in flight, and begins its write.
  // Control messages go first: they are small, and an Error should not wait behind an image. A
  // composite gets `skipped` only now, so that it counts frames replaced while it waited; it waits
  // on unless may_answer.
  std::optional<std::string> begin_write(std::uint64_t skipped, bool may_answer = true);
  void end_write() { writing_ = Writing::Nothing; }

  // Drops the waiting control messages, to make room for a last Error.
  void drop_control() { control_.clear(); }
  // Drops the waiting composite; true if there was one.
  bool drop_answer();

  bool writing() const { return writing_ != Writing::Nothing; }
  bool writing_answer() const { return writing_ == Writing::Answer; }
  bool empty() const { return !writing() && control_.empty() && !answer_; }

 private:
  enum class Writing { Nothing, Control, Answer };

  std::size_t max_control_;
  std::deque<std::string> control_;
  std::optional<Answer> answer_;
  Writing writing_ = Writing::Nothing;
};

}  // namespace amalgam::net
