#include "net/connection_limits.h"

#include <algorithm>

namespace amalgam::net {

ConnectionLimits::Ticket::Ticket(ConnectionLimits& limits, std::string address)
    : limits_(&limits), address_(std::move(address)) {
  limits_->count_address(address_);
  ++limits_->total_;
  ++limits_->unauthenticated_;
}

ConnectionLimits::Ticket::Ticket(Ticket&& other) noexcept
    : limits_(std::exchange(other.limits_, nullptr)),
      address_(std::move(other.address_)),
      authenticated_(other.authenticated_) {}

ConnectionLimits::Ticket::~Ticket() {
  if (limits_ == nullptr) return;
  if (!authenticated_) --limits_->unauthenticated_;
  --limits_->total_;
  limits_->uncount_address(address_);
}

void ConnectionLimits::Ticket::authenticated() {
  if (authenticated_) return;
  limits_->remember(address_);
  authenticated_ = true;
  --limits_->unauthenticated_;
}

std::variant<ConnectionLimits::Ticket, ConnectionLimits::Refusal> ConnectionLimits::admit(
    const std::string& address) {
  if (const auto refusal = judge_totals(address)) return *refusal;
  if (address_is_full(address)) return Refusal::PerAddress;
  return Ticket(*this, address);
}

std::variant<ConnectionLimits::Ticket, ConnectionLimits::Refusal> ConnectionLimits::admit_proxy(
    const std::string& address) {
  if (const auto refusal = judge_totals(address)) return *refusal;
  return Ticket(*this, address);
}

std::optional<ConnectionLimits::Refusal> ConnectionLimits::move(Ticket& ticket,
                                                                const std::string& address) {
  if (address_is_full(address)) return Refusal::PerAddress;
  count_address(address);
  uncount_address(ticket.address_);
  ticket.address_ = address;
  return std::nullopt;
}

std::optional<ConnectionLimits::Refusal> ConnectionLimits::judge_totals(
    const std::string& address) const {
  if (total_ >= caps_.total) return Refusal::Total;
  // Places that strangers cannot take.
  const std::size_t reserved = is_known(address) ? caps_.per_address : 0;
  if (unauthenticated_ >= caps_.unauthenticated + reserved) return Refusal::Unauthenticated;
  return std::nullopt;
}

bool ConnectionLimits::address_is_full(const std::string& address) const {
  const auto entry = by_address_.find(address);
  return entry != by_address_.end() && entry->second >= caps_.per_address;
}

void ConnectionLimits::count_address(const std::string& address) {
  ++by_address_[address];
}

void ConnectionLimits::uncount_address(const std::string& address) {
  const auto entry = by_address_.find(address);
  if (--entry->second == 0) by_address_.erase(entry);
}

bool ConnectionLimits::is_known(const std::string& address) const {
  return std::find(known_.begin(), known_.end(), address) != known_.end();
}

void ConnectionLimits::remember(const std::string& address) {
  const auto found = std::find(known_.begin(), known_.end(), address);
  if (found != known_.end()) return known_.splice(known_.begin(), known_, found);
  known_.push_front(address);
  if (known_.size() > kMaxKnown) known_.pop_back();
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
