// Slows down whoever sends wrong tokens or fails in the TLS handshake: after a few, an address has
// to wait, twice as long after each further one. Independent of sockets and clocks.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <string>

namespace amalgam::net {

class BackOff {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr int kFree = 5;  // somebody who mistypes a token
  static constexpr std::chrono::milliseconds kFirst{1000};
  static constexpr std::chrono::milliseconds kLongest{60'000};
  // Forgotten after this long without another one.
  static constexpr std::chrono::minutes kMemory{10};
  // Addresses remembered. Whoever has more addresses pushes out the one heard of longest ago.
  static constexpr std::size_t kMaxAddresses = 4096;

  void failed(const std::string& key, Time now);
  void succeeded(const std::string& key) { failures_.erase(key); }
  // How long the address has still to wait; 0: it may try.
  std::chrono::milliseconds left(const std::string& key, Time now) const;

 private:
  struct Failures {
    int count = 0;
    Time last{};
    Time until{};
  };
  std::map<std::string, Failures> failures_;
};

}  // namespace amalgam::net
