// What all records have in common: whether there are any, whose light shines, and where they are
// written. Outlives them. On the network's thread, except for report().
//
//   SessionRecording of each session -> RecordWriter's queue -> its thread -> RecordFile
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>

#include "protocol/session_record.pb.h"
#include "record/record_options.h"
#include "record/record_writer.h"

namespace amalgam::record {

class SessionRecording;

struct RecorderReport {
  std::string folder;  // empty: nothing is recorded
  WriterCounts counts;
};

class Recorder {
 public:
  explicit Recorder(RecordOptions options,
                    std::size_t most_waiting = protocol::kMaxRecordQueueBytes)
      : options_(std::move(options)), writer_(most_waiting) {}

  // Another scene or other options were loaded: records under way end.
  void reloaded(RecordOptions options);

  RecorderReport report() const { return {options_.folder, writer_.counts()}; }

 private:
  friend class SessionRecording;
  bool is_on() const { return !options_.folder.empty(); }
  void begin(SessionRecording& recording);
  // That session has lit all that have no light of their own.
  void lit(const SessionRecording* by, std::shared_ptr<const protocol::Environment> light);

  RecordOptions options_;
  std::set<SessionRecording*> recordings_;              // that have begun
  std::shared_ptr<const protocol::Environment> light_;  // of all; null: the scene's
  RecordWriter writer_;
};

}  // namespace amalgam::record
