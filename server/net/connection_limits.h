// Counts connections: all, those not yet authenticated, and by address. Refuses those above the
// caps. Owned by the network thread.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "net/server_config.h"

namespace amalgam::net {

class ConnectionLimits {
 public:
  explicit ConnectionLimits(const ConnectionCaps& caps) : caps_(caps) {}

  // One connection's entry in the counts, removed by the destructor. Must not outlive the
  // ConnectionLimits.
  class Ticket {
   public:
    Ticket(Ticket&& other) noexcept;
    Ticket& operator=(Ticket&&) = delete;
    ~Ticket();
    void authenticated();

   private:
    friend class ConnectionLimits;
    Ticket(ConnectionLimits& limits, std::string address);
    ConnectionLimits* limits_;
    std::string address_;
    bool authenticated_ = false;
  };

  enum class Refusal { Total, Unauthenticated, PerAddress };
  std::variant<Ticket, Refusal> admit(const std::string& address);

  bool full() const { return total_ >= caps_.total; }
  std::size_t total() const { return total_; }

 private:
  ConnectionCaps caps_;
  std::size_t total_ = 0;
  std::size_t unauthenticated_ = 0;
  std::map<std::string, std::size_t> by_address_;
};

const char* to_string(ConnectionLimits::Refusal refusal);

}  // namespace amalgam::net
