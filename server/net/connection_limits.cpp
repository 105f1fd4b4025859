#include "net/connection_limits.h"

namespace amalgam::net {

ConnectionLimits::Ticket::Ticket(ConnectionLimits& limits, std::string address)
    : limits_(&limits), address_(std::move(address)) {
  ++limits_->by_address_[address_];
  ++limits_->total_;
  ++limits_->unauthenticated_;
}

ConnectionLimits::Ticket::Ticket(Ticket&& other) noexcept
    : limits_(std::exchange(other.limits_, nullptr)),
      address_(std::move(other.address_)),
      authenticated_(other.authenticated_) {}

ConnectionLimits::Ticket::~Ticket() {
  if (limits_ == nullptr) return;
  authenticated();
  --limits_->total_;
  const auto entry = limits_->by_address_.find(address_);
  if (--entry->second == 0) limits_->by_address_.erase(entry);
}

void ConnectionLimits::Ticket::authenticated() {
  if (!std::exchange(authenticated_, true)) --limits_->unauthenticated_;
}

std::variant<ConnectionLimits::Ticket, ConnectionLimits::Refusal> ConnectionLimits::admit(
    const std::string& address) {
  if (total_ >= caps_.total) return Refusal::Total;
  if (unauthenticated_ >= caps_.unauthenticated) return Refusal::Unauthenticated;
  const auto entry = by_address_.find(address);
  if (entry != by_address_.end() && entry->second >= caps_.per_address) return Refusal::PerAddress;
  return Ticket(*this, address);
}

const char* to_string(ConnectionLimits::Refusal refusal) {
  switch (refusal) {
    case ConnectionLimits::Refusal::Total:
      return "connections";
    case ConnectionLimits::Refusal::Unauthenticated:
      return "unauthenticated";
    case ConnectionLimits::Refusal::PerAddress:
      return "address";
  }
  return "";
}

}  // namespace amalgam::net
