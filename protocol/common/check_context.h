// Says what a thread is doing, for the report of a check that fails meanwhile.
//
// The text is made only after a check has failed; until then, a context is an entry in a list.
//
//     const common::CheckContext context([&] { return "rendering frame " + std::to_string(id); });
#pragma once

#include <functional>
#include <string>
#include <thread>

namespace amalgam::common {

class CheckContext {
 public:
  // describe may be called from any thread until the context ends. What it reads must not change
  // while other threads may fail a check. It may throw. It must not make contexts.
  explicit CheckContext(std::function<std::string()> describe);
  ~CheckContext();
  CheckContext(const CheckContext&) = delete;
  CheckContext& operator=(const CheckContext&) = delete;

  // The texts of this thread's contexts, the innermost last, each followed by a newline. A thread
  // without contexts gets those of all threads, because workers work for one of them. Empty if
  // called by describe.
  static std::string describe_all();

 private:
  std::function<std::string()> describe_;
  std::thread::id thread_;
};

}  // namespace amalgam::common
