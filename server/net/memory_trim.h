// Gives memory back to the system that sessions and large messages have left in the allocator. Not
// so often that a busy server would always fetch it again; and once more after the last time,
// because whoever used that memory may free it a moment later.
#pragma once

#include <malloc.h>

#include <chrono>

#include "protocol/limits.h"

namespace amalgam::net {

// For all threads that are still to come. Of a heap that belongs to one thread, malloc_trim()
// leaves the top in place, which may be 16 MiB after large messages.
inline void share_one_heap() {
  ::mallopt(M_ARENA_MAX, 1);
}

class MemoryTrim {
 public:
  using Time = std::chrono::steady_clock::time_point;

  void left_behind() { due_ = 2; }
  void tick(Time now) {
    if (due_ == 0 || now - last_ <= protocol::kTrimInterval) return;
    ::malloc_trim(0);
    last_ = now;
    --due_;
  }

 private:
  int due_ = 0;
  Time last_{};
};

}  // namespace amalgam::net
