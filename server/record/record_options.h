// The operator's settings for records of sessions.
#pragma once

#include <cstdint>
#include <string>

#include "protocol/limits.h"

namespace amalgam::record {

struct RecordOptions {
  std::string folder;  // empty: nothing is recorded
  std::uint64_t session_bytes = protocol::kMaxSessionRecordBytes;
  // Of all records in the folder, earlier ones too.
  std::uint64_t total_bytes = protocol::kMaxRecordBytes;
};

}  // namespace amalgam::record
