// Accounts for every frame that a session received: it is answered, in the renderer, or counted as
// skipped with a reason.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "common/pose.h"
#include "net/metrics.h"

namespace amalgam::net {

class FrameLedger {
 public:
  explicit FrameLedger(Metrics& metrics) : metrics_(metrics) {}

  struct Entry {
    std::uint64_t ticket = 0;  // ours, because the client's id is not checked
    std::uint64_t frame_id = 0;
    std::uint64_t capture_time_us = 0;
    std::vector<common::MarkerPose> poses;  // rendered with
    std::chrono::steady_clock::time_point arrival;
  };

  // Returns the frame's ticket, counted from 1.
  std::uint64_t receive(std::size_t message_bytes);
  // The renderer took the frame. replaced: it dropped a waiting one for it.
  void submit(Entry entry, bool replaced);
  // The renderer is done with the frame. Nothing if the frame has been abandoned.
  std::optional<Entry> deliver(std::uint64_t ticket);
  void sent(std::size_t message_bytes);
  void skip(Skip reason, std::size_t count = 1);
  // The session has left the renderer: frames there will never come back.
  void abandon();

  std::size_t in_flight() const { return entries_.size(); }
  std::uint64_t received_count() const { return received_; }
  std::uint64_t sent_count() const { return sent_; }
  std::uint64_t skipped_count() const { return skipped_; }
  std::uint64_t skipped_count(Skip reason) const {
    return skipped_by_[static_cast<std::size_t>(reason)];
  }
  std::uint64_t bytes_received() const { return bytes_received_; }
  std::uint64_t bytes_sent() const { return bytes_sent_; }

 private:
  Metrics& metrics_;
  std::deque<Entry> entries_;  // one being rendered, one waiting, and results not yet delivered
  std::uint64_t received_ = 0, sent_ = 0, skipped_ = 0;
  std::array<std::uint64_t, kSkips.size()> skipped_by_{};
  std::uint64_t bytes_received_ = 0, bytes_sent_ = 0;  // of messages
};

}  // namespace amalgam::net
