// Writes log lines to a descriptor whose reader may be slow, stuck or gone. A line that cannot be
// written within a second is dropped and counted; from then on nothing is waited for until the
// reader is back.
#pragma once

#include <spdlog/sinks/base_sink.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string_view>

namespace amalgam::common {

class LogSink : public spdlog::sinks::base_sink<std::mutex> {
 public:
  // descriptor: stays the caller's.
  explicit LogSink(int descriptor) : descriptor_(descriptor) {}

  // Lines that were dropped before they came here, so that the log can tell of them.
  void count_also(std::function<std::uint64_t()> dropped_before);
  std::uint64_t dropped() const { return dropped_; }

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override;
  void flush_() override {}

 private:
  bool write(std::string_view text);
  void tell_dropped();

  int descriptor_;
  std::function<std::uint64_t()> dropped_before_;
  std::atomic<std::uint64_t> dropped_ = 0;
  std::uint64_t told_ = 0;
  bool stuck_ = false;
};

}  // namespace amalgam::common
