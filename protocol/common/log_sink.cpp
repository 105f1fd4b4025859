#include "common/log_sink.h"

#include <limits.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <utility>

namespace amalgam::common {
namespace {

constexpr int kPatienceMs = 1000;

}  // namespace

void LogSink::count_also(std::function<std::uint64_t()> dropped_before) {
  const std::lock_guard lock(mutex_);
  dropped_before_ = std::move(dropped_before);
}

void LogSink::sink_it_(const spdlog::details::log_msg& message) {
  spdlog::memory_buf_t line;
  formatter_->format(message, line);
  if (!write({line.data(), line.size()})) {
    ++dropped_;
    return;
  }
  tell_dropped();
}

// A pipe that poll() calls writable takes PIPE_BUF bytes without blocking.
bool LogSink::write(std::string_view text) {
  while (!text.empty()) {
    pollfd ready{descriptor_, POLLOUT, 0};
    stuck_ = ::poll(&ready, 1, stuck_ ? 0 : kPatienceMs) <= 0;
    if (stuck_) return false;
    const ssize_t size =
        ::write(descriptor_, text.data(), std::min<std::size_t>(text.size(), PIPE_BUF));
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return false;  // nobody reads any more, or the disk is full
    text.remove_prefix(static_cast<std::size_t>(size));
  }
  return true;
}

void LogSink::tell_dropped() {
  const std::uint64_t all = dropped_ + (dropped_before_ ? dropped_before_() : 0);
  if (all == told_) return;
  const std::string text = std::to_string(all - told_) + " log lines were dropped";
  spdlog::memory_buf_t line;
  formatter_->format({{}, spdlog::level::warn, text}, line);
  if (write({line.data(), line.size()})) told_ = all;
}

}  // namespace amalgam::common
