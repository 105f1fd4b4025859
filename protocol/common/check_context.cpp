#include "common/check_context.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <utility>
#include <vector>

namespace amalgam::common {
namespace {

struct Registry {
  std::mutex mutex;
  std::vector<const CheckContext*> contexts;  // the oldest first
};

Registry& registry() {
  static Registry& instance = *new Registry;  // never destroyed: checks may fail at exit
  return instance;
}

thread_local bool is_describing = false;

}  // namespace

CheckContext::CheckContext(std::function<std::string()> describe)
    : describe_(std::move(describe)), thread_(std::this_thread::get_id()) {
  const std::lock_guard lock(registry().mutex);
  registry().contexts.push_back(this);
}

CheckContext::~CheckContext() {
  const std::lock_guard lock(registry().mutex);
  std::erase(registry().contexts, this);
}

std::string CheckContext::describe_all() {
  if (is_describing) return {};  // a check has failed in describe, under the lock
  is_describing = true;
  std::string text;
  {
    // No context can end under the lock, so what they read stays valid.
    const std::lock_guard lock(registry().mutex);
    const auto& contexts = registry().contexts;
    const auto is_ours = [](const CheckContext* context) {
      return context->thread_ == std::this_thread::get_id();
    };
    const bool have_ours = std::any_of(contexts.begin(), contexts.end(), is_ours);
    for (const CheckContext* context : contexts) {
      if (have_ours && !is_ours(context)) continue;
      try {
        text += context->describe_() + "\n";
      } catch (const std::exception& error) {
        text += std::string("(cannot be described: ") + error.what() + ")\n";
      }
    }
  }
  is_describing = false;
  return text;
}

}  // namespace amalgam::common
