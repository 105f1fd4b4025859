// The folder that records lie in: their names, and the room that they take.
#pragma once

#include <cstdint>
#include <string>

namespace amalgam::record {

inline constexpr const char* kRecordExtension = ".session";

// Where a session's record is to lie. Its name has the time, the process and the session, so that
// no two sessions of a machine share one.
std::string record_path(const std::string& folder, std::uint64_t session);

// Bytes of all records in the folder; 0 if it cannot be read.
std::uint64_t bytes_of_records(const std::string& folder);

// Now, as 2026-01-31T12:00:00Z.
std::string utc_now();

}  // namespace amalgam::record
