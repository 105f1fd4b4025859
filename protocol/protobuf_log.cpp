#include "protocol/protobuf_log.h"

#include <google/protobuf/stubs/logging.h>

#include <string>

#include "common/log.h"

namespace amalgam::protocol {
namespace {

void log(google::protobuf::LogLevel level, const char*, int, const std::string& message) {
  // Its complaints are about bytes from strangers, who are answered anyway.
  if (level >= google::protobuf::LOGLEVEL_FATAL) return common::log_error(message);
  common::log_debug("protobuf: " + message);
}

}  // namespace

void take_over_protobuf_log() {
  google::protobuf::SetLogHandler(log);
}

}  // namespace amalgam::protocol
