#include "faults/control_client.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>

#include "faults/figure.h"

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

ControlClient::Felt ControlClient::feel_alone(const common::HostPort& server,
                                              const std::string& token) {
  ControlClient control(server, token);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  return control.end();
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

void expect_unharmed(const std::string& row, const ControlClient::Felt& alone,
                     const ControlClient::Felt& beside, double allowed_ms) {
  const double limit = std::max(1.1 * alone.p99_ms, alone.p99_ms + allowed_ms);
  print_figure(row, "control's p99, alone", alone.p99_ms, "ms", "-");
  print_figure(row, "control's p99, beside", beside.p99_ms, "ms",
               "+10 % or " + std::to_string(static_cast<int>(allowed_ms)) + " ms");
  EXPECT_FALSE(beside.lost) << "row " << row;
  // Of the last minute. The test itself is one, and a little.
  constexpr double kQuiet = 1.3;
  double load = 0.0;
  const bool quiet = ::getloadavg(&load, 1) == 1 && load < kQuiet;
  if (quiet) {
    EXPECT_LE(beside.p99_ms, limit) << "row " << row;
  } else if (beside.p99_ms > limit) {
    std::printf("row %s: above the limit, on a machine with a load of %.1f: not judged\n",
                row.c_str(), load);
  }
}

}  // namespace amalgam::test
