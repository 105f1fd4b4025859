// A place for one message between two threads, where the newest wins: putting a second one throws
// the first away and says so, because a mixed-reality viewer wants the present and not a queue.
#pragma once

#include <mutex>
#include <optional>
#include <utility>

namespace amalgam::common {

template <typename T>
class Mailbox {
 public:
  // Returns the message that was waiting and will now never be taken, if any.
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
