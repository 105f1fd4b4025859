#include "faults/control_client.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "client/link/messages.h"
#include "faults/figure.h"
#include "protocol/framing.h"

namespace amalgam::test {

ControlClient::ControlClient(const common::HostPort& server, const std::string& token)
    : connection_({.server = server},
                  client::hello_message(common::default_camera(640, 480), token, 0)) {
  if (!next<client::Welcomed>()) throw std::runtime_error("the healthy client was not let in");
  thread_ = std::thread([this] { run(); });
}

template <typename Event>
std::optional<Event> ControlClient::next() {
  auto event = connection_.wait(std::chrono::seconds(10));
  if (!event || !std::holds_alternative<Event>(*event)) return std::nullopt;
  return std::get<Event>(std::move(*event));
}

ControlClient::~ControlClient() {
  end();
}

void ControlClient::run() {
  using Clock = std::chrono::steady_clock;
  constexpr std::array<unsigned char, 4> kJpeg{'j', 'p', 'e', 'g'};
  for (std::uint64_t id = 1; !stop_ && !lost_; ++id) {
    const auto begin = Clock::now();
    connection_.send(id, protocol::encode(client::frame_message(id, kJpeg, begin, {})));
    const auto answer = next<client::Composited>();
    lost_ = !answer || answer->composite.frame_id() != id;
    if (lost_) return;
    milliseconds_.push_back(std::chrono::duration<double, std::milli>(answer->at - begin).count());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
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
  if (std::getenv("AMALGAM_QUIET_MACHINE") != nullptr) {
    EXPECT_LE(beside.p99_ms, limit) << "row " << row;
  } else if (beside.p99_ms > limit) {
    std::printf("row %s: above the limit: not judged without AMALGAM_QUIET_MACHINE\n", row.c_str());
  }
}

}  // namespace amalgam::test
