// Clients that come back at once, by the same address, whenever their server sends them away or
// dies.
#pragma once

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "common/host_port.h"

namespace amalgam::test {

class RoamingClients {
 public:
  RoamingClients(const common::HostPort& address, std::size_t count, std::string jpeg);
  ~RoamingClients();

  // Whether every one of them has had a frame since this was called, within ten seconds.
  bool all_served() const;

  struct Felt {
    std::size_t frames = 0;
    std::size_t returns = 0;   // connections after the first one
    std::size_t refused = 0;   // connections without a Welcome
    double longest_gap_s = 0;  // without a composite, for any of them
  };
  // Ends them.
  Felt end();

 private:
  struct Client {
    std::atomic<std::size_t> frames = 0;
    Felt felt;
    std::thread thread;
  };
  void run(Client& client) const;
  // Frames until the connection ends. False if there never was a session.
  bool play(Client& client, double& last_frame_s) const;

  common::HostPort address_;
  std::string jpeg_;
  std::atomic<bool> stop_ = false;
  std::vector<Client> clients_;
};

}  // namespace amalgam::test
