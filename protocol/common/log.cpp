#include "common/log.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <stdexcept>

#include "common/check_context.h"

namespace amalgam::common {
namespace {

spdlog::logger& logger() {
  static const std::shared_ptr<spdlog::logger> instance = [] {
    auto made = spdlog::stderr_logger_mt("amalgam");
    made->set_pattern("%Y-%m-%dT%H:%M:%S.%e %l %v");
    return made;
  }();
  return *instance;
}

}  // namespace

void set_log_level(std::string_view level) {
  const auto parsed = spdlog::level::from_str(std::string(level));
  if (parsed == spdlog::level::off && level != "off") {
    throw std::invalid_argument("log level '" + std::string(level) +
                                "' is none of trace, debug, info, warn, error, off");
  }
  logger().set_level(parsed);
}

void log_debug(const std::string& message) {
  logger().debug(message);
}
void log_info(const std::string& message) {
  logger().info(message);
}
void log_warn(const std::string& message) {
  logger().warn(message);
}
void log_error(const std::string& message) {
  logger().error(message);
}

void check_failed(const char* condition, const char* file, int line, const std::string& values) {
  // Printed first, in case making the context fails too.
  logger().critical("CHECK failed: {} at {}:{}: {}", condition, file, line, values);
  logger().flush();
  const std::string context = CheckContext::describe_all();
  if (!context.empty()) logger().critical("while\n{}", context);
  logger().flush();
  std::abort();
}

}  // namespace amalgam::common
