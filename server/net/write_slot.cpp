#include "net/write_slot.h"

#include <utility>

#include "net/wire.h"
#include "protocol/framing.h"

namespace amalgam::net {

bool WriteSlot::put_control(const protocol::Envelope& message) {
  if (control_.size() >= max_control_) return false;
  control_.push_back(protocol::encode(message));
  return true;
}

bool WriteSlot::put_answer(Answer answer) {
  return std::exchange(answer_, std::move(answer)).has_value();
}

std::optional<std::string> WriteSlot::begin_write(std::uint64_t skipped, bool may_answer) {
  if (writing()) return std::nullopt;
  if (!control_.empty()) {
    writing_ = Writing::Control;
    std::string bytes = std::move(control_.front());
    control_.pop_front();
    return bytes;
  }
  if (!answer_ || !may_answer) return std::nullopt;
  writing_ = Writing::Answer;
  return protocol::encode(composite_message(*std::exchange(answer_, std::nullopt), skipped));
}

bool WriteSlot::drop_answer() {
  return std::exchange(answer_, std::nullopt).has_value();
}

}  // namespace amalgam::net
