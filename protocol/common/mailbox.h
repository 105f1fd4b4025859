// Holds one message between two threads; the newest wins. A second message replaces the first,
// because a mixed-reality viewer wants the present and not a queue.
#pragma once

#include <mutex>
#include <optional>
#include <utility>

namespace amalgam::common {

template <typename T>
class Mailbox {
 public:
  // Returns the replaced message, if any, which will never be taken.
  std::optional<T> put(T message) {
    const std::lock_guard lock(mutex_);
    return std::exchange(waiting_, std::optional<T>(std::move(message)));
  }

  std::optional<T> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(waiting_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::optional<T> waiting_;
};

}  // namespace amalgam::common
