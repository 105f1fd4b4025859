// What a thread is doing while it does it, for the report of a check that fails meanwhile.
//
// Costs an entry in a list: the text is made only when a check has failed.
//
//     const common::CheckContext context([&] { return "rendering frame " + std::to_string(id); });
#pragma once

#include <functional>
#include <string>
#include <thread>

namespace amalgam::common {

class CheckContext {
 public:
  // describe may be called from any thread until the context ends, and what it reads must not
  // change meanwhile. It may throw, and must not make contexts.
  explicit CheckContext(std::function<std::string()> describe);
  ~CheckContext();
  CheckContext(const CheckContext&) = delete;
  CheckContext& operator=(const CheckContext&) = delete;

  // The texts of this thread's contexts, a line each, the innermost last. Of all threads' where
  // this one has none: a worker is helping one of them. Empty inside of describe.
  static std::string describe_all();

 private:
  std::function<std::string()> describe_;
  std::thread::id thread_;
};

}  // namespace amalgam::common
