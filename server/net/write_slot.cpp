#include "net/write_slot.h"

#include <utility>

#include "protocol/framing.h"

namespace amalgam::net {

bool WriteSlot::put_control(const protocol::Envelope& message) {
  if (control_.size() >= max_control_) return false;
  control_.push_back(protocol::encode(message));
  return true;
}

bool WriteSlot::put_composite(protocol::Composite composite) {
  return std::exchange(composite_, std::move(composite)).has_value();
}

std::optional<std::string> WriteSlot::begin_write(std::uint64_t skipped) {
  if (writing()) return std::nullopt;
  if (!control_.empty()) {
    writing_ = Writing::Control;
    std::string bytes = std::move(control_.front());
    control_.pop_front();
    return bytes;
  }
  if (!composite_) return std::nullopt;
  writing_ = Writing::Composite;
  protocol::Envelope envelope;
  *envelope.mutable_composite() = *std::exchange(composite_, std::nullopt);
  envelope.mutable_composite()->set_skipped(skipped);
  return protocol::encode(envelope);
}

bool WriteSlot::drop_composite() {
  return std::exchange(composite_, std::nullopt).has_value();
}

}  // namespace amalgam::net
