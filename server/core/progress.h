// The progress of the frame that is being rendered, told to other threads; they may cancel it.
#pragma once

#include <atomic>
#include <cstdint>
#include <stdexcept>

namespace amalgam::core {

// Thrown in the middle of a frame that nobody waits for any more.
struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("cancelled") {}
};

class Progress {
 public:
  // A new frame, which is not cancelled. Does not throw.
  void begin() {
    cancelled_ = false;
    steps_.fetch_add(1, std::memory_order_relaxed);
  }
  void cancel() { cancelled_ = true; }

  // Called at each tile and each pass. Throws Cancelled.
  void step() {
    steps_.fetch_add(1, std::memory_order_relaxed);
    if (cancelled_.load(std::memory_order_relaxed)) throw Cancelled();
  }
  // As long as this grows, the renderer is alive.
  std::uint64_t steps() const { return steps_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> cancelled_ = false;
  std::atomic<std::uint64_t> steps_ = 0;
};

}  // namespace amalgam::core
