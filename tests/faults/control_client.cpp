#include "faults/control_client.h"

#include <algorithm>
#include <chrono>
#include <exception>

namespace amalgam::test {

ControlClient::ControlClient(const common::HostPort& server, const std::string& token)
    : client_(server) {
  protocol::Envelope hello = hello_message();
  hello.mutable_hello()->set_token(token);
  client_.send(hello);
  client_.expect(protocol::Envelope::kWelcome);
  thread_ = std::thread([this] { run(); });
}

ControlClient::~ControlClient() {
  end();
}

void ControlClient::run() {
  using Clock = std::chrono::steady_clock;
  try {
    for (std::uint64_t id = 1; !stop_; ++id) {
      const auto begin = Clock::now();
      client_.send(frame_message(id));
      client_.expect(protocol::Envelope::kComposite);
      milliseconds_.push_back(
          std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  } catch (const std::exception&) {
    lost_ = true;
  }
}

ControlClient::Felt ControlClient::end() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
  Felt felt{.frames = milliseconds_.size(), .lost = lost_};
  if (milliseconds_.empty()) return felt;
  std::vector<double> sorted = milliseconds_;
  std::sort(sorted.begin(), sorted.end());
  felt.median_ms = sorted[sorted.size() / 2];
  felt.p99_ms = sorted[sorted.size() * 99 / 100];
  felt.worst_ms = sorted.back();
  return felt;
}

}  // namespace amalgam::test
