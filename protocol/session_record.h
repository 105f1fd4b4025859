// Files of recorded sessions (session_record.proto): how one is read, by whoever plays it again.
// They are written by server/record, with protocol::encode.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>

#include "protocol/session_record.pb.h"

namespace amalgam::protocol {

inline constexpr std::uint32_t kRecordFormat = 1;

class SessionRecordReader {
 public:
  // Reads the header. Throws std::runtime_error if the file cannot be read or begins without one.
  explicit SessionRecordReader(const std::filesystem::path& path);

  const RecordHeader& header() const { return header_; }
  // The next one behind the header; nothing at the end, or where the file was cut. Throws
  // std::runtime_error for bytes that are no record.
  std::optional<SessionRecord> next();
  // Whether the file ends in the middle of a record, after next() has returned nothing.
  bool was_cut() const { return cut_; }

 private:
  std::filesystem::path path_;
  std::ifstream file_;
  RecordHeader header_;
  bool cut_ = false;
};

}  // namespace amalgam::protocol
