// Logging to standard error, with a level that is set once at start.
#pragma once

#include <string>
#include <string_view>

namespace amalgam::common {

// One of: trace, debug, info, warn, error, off. Throws std::invalid_argument for anything else.
void set_log_level(std::string_view level);

void log_debug(const std::string& message);
void log_info(const std::string& message);
void log_warn(const std::string& message);
void log_error(const std::string& message);

// For a broken invariant: prints the condition, the values and the contexts of the thread
// (common/check_context.h), then aborts. While a frame is rendered, that says how to replay it.
[[noreturn]] void check_failed(const char* condition, const char* file, int line,
                               const std::string& values);

}  // namespace amalgam::common

// AMALGAM_CHECK(condition, values): values is a std::string, evaluated only if the check fails.
#define AMALGAM_CHECK(condition, values)                                         \
  do {                                                                           \
    if (!(condition)) {                                                          \
      ::amalgam::common::check_failed(#condition, __FILE__, __LINE__, (values)); \
    }                                                                            \
  } while (false)
