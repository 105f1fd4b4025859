// One session's record on its way to the disk, as the network's thread and the writer's share it.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>

#include "protocol/session_record.pb.h"
#include "record/record_file.h"
#include "record/record_options.h"

namespace amalgam::record {

// What has become of a record. All but Off and On are ends.
enum class Fate {
  Off,       // there is none
  On,        // being written
  Closed,    // as its session
  Full,      // no room for more
  TooSlow,   // the disk did not keep up
  Failed,    // the disk refused, or memory was missing
  Reloaded,  // the server took another scene or other options
};
const char* to_string(Fate fate);

struct Track {
  using Clock = std::chrono::steady_clock;

  Track(std::uint64_t session_id, RecordOptions record_options)
      : session(session_id), options(std::move(record_options)) {}

  const std::uint64_t session;
  const RecordOptions options;
  const Clock::time_point begin = Clock::now();
  std::atomic<Fate> fate = Fate::On;
  std::atomic<std::uint64_t> bytes = 0;  // written

  // The writer's thread's own.
  std::unique_ptr<RecordFile> file;
  bool begun = false, over = false;
};

// A record of now, without its event.
protocol::SessionRecord record_now(const Track& track);

}  // namespace amalgam::record
