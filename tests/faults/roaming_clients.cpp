#include "faults/roaming_clients.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "support/net/test_client.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using namespace std::chrono_literals;

constexpr auto kFramePeriod = 100ms;

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

RoamingClients::RoamingClients(const common::HostPort& address, std::size_t count, std::string jpeg)
    : address_(address), jpeg_(std::move(jpeg)), clients_(count) {
  for (Client& client : clients_) client.thread = std::thread([this, &client] { run(client); });
}

RoamingClients::~RoamingClients() {
  end();
}

bool RoamingClients::all_served() const {
  std::vector<std::size_t> before;
  for (const Client& client : clients_) before.push_back(client.frames);
  for (const double begin = now_s(); now_s() - begin < 10.0; std::this_thread::sleep_for(10ms)) {
    std::size_t served = 0;
    for (std::size_t i = 0; i < clients_.size(); ++i) served += clients_[i].frames > before[i];
    if (served == clients_.size()) return true;
  }
  return false;
}

RoamingClients::Felt RoamingClients::end() {
  stop_ = true;
  Felt sum;
  for (Client& client : clients_) {
    if (client.thread.joinable()) client.thread.join();
    sum.frames += client.frames;
    sum.returns += client.felt.returns;
    sum.refused += client.felt.refused;
    sum.longest_gap_s = std::max(sum.longest_gap_s, client.felt.longest_gap_s);
  }
  return sum;
}

void RoamingClients::run(Client& client) const {
  double last_frame_s = now_s();
  for (bool first = true; !stop_; first = false) {
    if (!first) ++client.felt.returns;
    if (!play(client, last_frame_s)) {
      ++client.felt.refused;
      std::this_thread::sleep_for(50ms);
    }
  }
}

bool RoamingClients::play(Client& client, double& last_frame_s) const {
  bool welcomed = false;
  try {
    TestClient connection(address_);
    connection.send(hello_message());
    for (std::uint64_t id = 0; !stop_;) {
      const auto message = connection.receive();
      if (!message || message->has_draining()) break;
      if (message->has_welcome()) welcomed = true;
      if (message->has_composite()) {
        ++client.frames;
        const double gap_s = now_s() - last_frame_s;
        last_frame_s += gap_s;
        client.felt.longest_gap_s = std::max(client.felt.longest_gap_s, gap_s);
        std::this_thread::sleep_for(kFramePeriod);
      } else if (!message->has_welcome()) {
        break;
      }
      connection.send(frame_message(++id, jpeg_));
    }
  } catch (const std::exception&) {  // reset
  }
  return welcomed || stop_;
}

}  // namespace amalgam::test
