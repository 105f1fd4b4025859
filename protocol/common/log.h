// Logging to standard error. Programs that must never wait for a reader log in the background.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace amalgam::common {

// One of: trace, debug, info, warn, error, off. Throws std::invalid_argument for anything else.
void set_log_level(std::string_view level);

// text, or json: an object with time, level and message on each line. Throws std::invalid_argument
// for anything else.
void set_log_format(std::string_view format);

// While it lives, lines wait in a bounded queue for a thread that writes them, so that whoever logs
// never waits. When the queue is full the oldest line is dropped and counted. The destructor waits
// for the queue to be written, or a second. One at a time.
class BackgroundLog {
 public:
  BackgroundLog();
  ~BackgroundLog();
  BackgroundLog(const BackgroundLog&) = delete;
  BackgroundLog& operator=(const BackgroundLog&) = delete;
};

// Lines that were dropped so far, because nobody read them in time.
std::uint64_t dropped_log_lines();

void log_debug(const std::string& message);
void log_info(const std::string& message);
void log_warn(const std::string& message);
void log_error(const std::string& message);

// What strangers can cause. Each kind has a limited number of lines a second; the next line says
// how many were left out.
enum class LogKind { Session, Refusal, Accept, Frame };
inline constexpr std::size_t kLogKinds = 4;
void log_info(LogKind kind, const std::string& message);
void log_warn(LogKind kind, const std::string& message);
void log_error(LogKind kind, const std::string& message);

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
