// Counts connections: all, those not yet authenticated, and by address. Refuses those above the
// caps; addresses that a client was let in from lately still find room when strangers have taken
// all places. Owned by the network thread.
#pragma once

#include <cstddef>
#include <list>
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
    const std::string& address() const { return address_; }

   private:
    friend class ConnectionLimits;
    Ticket(ConnectionLimits& limits, std::string address);
    ConnectionLimits* limits_;
    std::string address_;
    bool authenticated_ = false;
  };

  enum class Refusal { Total, Unauthenticated, PerAddress };
  // address: an address_key().
  std::variant<Ticket, Refusal> admit(const std::string& address);
  // A proxy's connection turns out to be this address's.
  std::optional<Refusal> move(Ticket& ticket, const std::string& address);
  // For connections of trusted proxies, until their header is read.
  std::variant<Ticket, Refusal> admit_proxy(const std::string& address);
  void set_caps(const ConnectionCaps& caps) { caps_ = caps; }

  bool full() const { return total_ >= caps_.total; }
  bool full_of_strangers() const { return unauthenticated_ >= caps_.unauthenticated; }
  double free_part() const {
    return full() ? 0.0 : 1.0 - static_cast<double>(total_) / static_cast<double>(caps_.total);
  }
  std::size_t total() const { return total_; }
  std::size_t unauthenticated() const { return unauthenticated_; }

 private:
  static constexpr std::size_t kMaxKnown = 1024;

  std::optional<Refusal> judge_totals(const std::string& address) const;
  bool address_is_full(const std::string& address) const;
  void count_address(const std::string& address);
  void uncount_address(const std::string& address);
  bool is_known(const std::string& address) const;
  void remember(const std::string& address);

  ConnectionCaps caps_;
  std::size_t total_ = 0;
  std::size_t unauthenticated_ = 0;
  std::map<std::string, std::size_t> by_address_;
  std::list<std::string> known_;  // the latest first
};

const char* to_string(ConnectionLimits::Refusal refusal);

}  // namespace amalgam::net
