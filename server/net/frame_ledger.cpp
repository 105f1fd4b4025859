#include "net/frame_ledger.h"

#include <algorithm>
#include <utility>

namespace amalgam::net {

std::uint64_t FrameLedger::receive(std::size_t message_bytes) {
  metrics_.frame_received(message_bytes);
  bytes_received_ += message_bytes;
  return ++received_;
}

void FrameLedger::submit(Entry entry, bool replaced) {
  if (replaced) {
    // The frame that waits is always the latest one submitted.
    entries_.pop_back();
    skip(Skip::ReplacedBeforeRender);
  }
  entries_.push_back(std::move(entry));
}

std::optional<FrameLedger::Entry> FrameLedger::deliver(std::uint64_t ticket) {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return entry.ticket == ticket; });
  if (found == entries_.end()) return std::nullopt;
  Entry entry = std::move(*found);
  entries_.erase(found);
  return entry;
}

void FrameLedger::sent(std::size_t message_bytes) {
  ++sent_;
  bytes_sent_ += message_bytes;
  metrics_.composite_sent(message_bytes);
}

void FrameLedger::skip(Skip reason, std::size_t count) {
  skipped_ += count;
  skipped_by_[static_cast<std::size_t>(reason)] += count;
  metrics_.frame_skipped(reason, count);
}

void FrameLedger::abandon() {
  if (!entries_.empty()) skip(Skip::Closed, entries_.size());
  entries_.clear();
}

}  // namespace amalgam::net
