#include "common/log.h"

#include <spdlog/async_logger.h>
#include <spdlog/details/thread_pool.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "common/check_context.h"
#include "common/log_limiter.h"
#include "common/log_sink.h"
#include "common/one_line.h"

namespace amalgam::common {
namespace {

constexpr std::size_t kQueue = 1024;  // lines: some seconds of a busy server

// The message as a JSON string, quotes included.
class JsonMessage : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm&,
              spdlog::memory_buf_t& out) override {
    const nlohmann::json text(std::string(message.payload.data(), message.payload.size()));
    const std::string quoted = text.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    out.append(quoted.data(), quoted.data() + quoted.size());
  }
  std::unique_ptr<custom_flag_formatter> clone() const override {
    return std::make_unique<JsonMessage>();
  }
};

// The message as one line, because it may quote a client or a file. A failed CHECK's replay text,
// which is our own, has several.
class TextMessage : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm&,
              spdlog::memory_buf_t& out) override {
    std::string_view rest(message.payload.data(), message.payload.size());
    while (message.level == spdlog::level::critical && rest.find('\n') != rest.npos) {
      append(common::one_line(rest.substr(0, rest.find('\n'))) + "\n", out);
      rest.remove_prefix(rest.find('\n') + 1);
    }
    append(common::one_line(rest), out);
  }
  std::unique_ptr<custom_flag_formatter> clone() const override {
    return std::make_unique<TextMessage>();
  }

 private:
  static void append(const std::string& text, spdlog::memory_buf_t& out) {
    out.append(text.data(), text.data() + text.size());
  }
};

std::unique_ptr<spdlog::formatter> make_formatter(bool json) {
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  if (json) {
    formatter->add_flag<JsonMessage>('*').set_pattern(
        R"({"time":"%Y-%m-%dT%H:%M:%S.%e%z","level":"%l","message":%*})");
  } else {
    formatter->add_flag<TextMessage>('*').set_pattern("%Y-%m-%dT%H:%M:%S.%e %l %*");
  }
  return formatter;
}

// Never destroyed: whoever logs last still can.
struct Log {
  std::shared_ptr<LogSink> sink = std::make_shared<LogSink>(STDERR_FILENO);
  spdlog::logger direct{"amalgam", sink};
  std::shared_ptr<spdlog::details::thread_pool> pool;
  // The same, for other threads: the pool's own must not keep it alive, or it would end itself.
  std::atomic<spdlog::details::thread_pool*> queue = nullptr;
  std::shared_ptr<spdlog::async_logger> background;
  std::atomic<spdlog::logger*> current = &direct;
  LogLimiter limiter;
  std::atomic<std::uint64_t> dropped_in_queues = 0;  // of queues that are gone

  Log() {
    sink->set_formatter(make_formatter(false));
    sink->count_also([this] { return dropped_in_queue(); });
  }
  std::uint64_t dropped_in_queue() const {
    spdlog::details::thread_pool* const pool_now = queue;
    return dropped_in_queues + (pool_now != nullptr ? pool_now->overrun_counter() : 0);
  }
};

Log& the_log() {
  static Log* const log = new Log;
  return *log;
}

void log_limited(LogKind kind, spdlog::level::level_enum level, const std::string& message) {
  Log& log = the_log();
  if (!log.current.load()->should_log(level)) return;
  const auto left_out = log.limiter.admit(kind, std::chrono::steady_clock::now());
  if (!left_out) return;
  if (*left_out == 0) return log.current.load()->log(level, message);
  log.current.load()->log(
      level, message + " (" + std::to_string(*left_out) + " lines of this kind were left out)");
}

}  // namespace

void set_log_level(std::string_view level) {
  const auto parsed = spdlog::level::from_str(std::string(level));
  if (parsed == spdlog::level::off && level != "off") {
    throw std::invalid_argument("log level '" + std::string(level) +
                                "' is none of trace, debug, info, warn, error, off");
  }
  Log& log = the_log();
  log.direct.set_level(parsed);
  if (log.background) log.background->set_level(parsed);
}

void set_log_format(std::string_view format) {
  if (format != "text" && format != "json") {
    throw std::invalid_argument("log format '" + std::string(format) + "' is none of text, json");
  }
  the_log().sink->set_formatter(make_formatter(format == "json"));
}

BackgroundLog::BackgroundLog() {
  Log& log = the_log();
  log.pool = std::make_shared<spdlog::details::thread_pool>(kQueue, 1);
  log.background = std::make_shared<spdlog::async_logger>(
      "amalgam", log.sink, log.pool, spdlog::async_overflow_policy::overrun_oldest);
  log.background->set_level(log.direct.level());
  log.queue = log.pool.get();
  log.current = log.background.get();
}

BackgroundLog::~BackgroundLog() {
  Log& log = the_log();
  log.current = &log.direct;
  log.queue = nullptr;
  log.dropped_in_queues += log.pool->overrun_counter();
  log.background.reset();
  log.pool.reset();  // writes what waits: at most a second of it is waiting (LogSink)
}

std::uint64_t dropped_log_lines() {
  const Log& log = the_log();
  return log.sink->dropped() + log.dropped_in_queue();
}

void log_debug(const std::string& message) {
  the_log().current.load()->debug(message);
}
void log_info(const std::string& message) {
  the_log().current.load()->info(message);
}
void log_warn(const std::string& message) {
  the_log().current.load()->warn(message);
}
void log_error(const std::string& message) {
  the_log().current.load()->error(message);
}

void log_info(LogKind kind, const std::string& message) {
  log_limited(kind, spdlog::level::info, message);
}
void log_warn(LogKind kind, const std::string& message) {
  log_limited(kind, spdlog::level::warn, message);
}
void log_error(LogKind kind, const std::string& message) {
  log_limited(kind, spdlog::level::err, message);
}

void check_failed(const char* condition, const char* file, int line, const std::string& values) {
  // Not in the background, which ends with the process. Printed first, in case making the context
  // fails too.
  spdlog::logger& logger = the_log().direct;
  logger.critical("CHECK failed: {} at {}:{}: {}", condition, file, line, values);
  const std::string context = CheckContext::describe_all();
  if (!context.empty()) logger.critical("while\n{}", context);
  std::abort();
}

}  // namespace amalgam::common
