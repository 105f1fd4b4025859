// Writes records on a thread of its own, so that no session waits for the disk. What waits for that
// thread is bounded, and so are the files: where there is no room a record ends, and nothing else.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "record/track.h"

namespace amalgam::record {

// Counted since the writer was made.
struct WriterCounts {
  std::uint64_t bytes = 0;                           // written
  std::uint64_t begun = 0;                           // records
  std::uint64_t ended = 0;                           // of these, in whatever way
  std::uint64_t full = 0, too_slow = 0, failed = 0;  // of those: before their session
};

class RecordWriter {
 public:
  // most_waiting: bytes that may wait for the disk.
  explicit RecordWriter(std::size_t most_waiting) : most_waiting_(most_waiting) {}
  // Writes what waits.
  ~RecordWriter() = default;

  // Encoded records; the first one begins the file. Nothing happens if the track has ended. Ends it
  // as TooSlow if too much waits.
  void append(const std::shared_ptr<Track>& track, std::string bytes);
  // Does nothing if the track has ended already.
  void end(const std::shared_ptr<Track>& track, Fate fate);

  WriterCounts counts() const;

 private:
  struct Item {
    std::shared_ptr<Track> track;
    std::string bytes;  // empty: the track ends, in this way
    Fate end = Fate::Closed;
  };

  void put(Item item);  // under mutex_
  void run(const std::stop_token& stop);
  void write(Track& track, const std::string& bytes);
  void begin(Track& track);
  void append_now(Track& track, const std::string& bytes);
  void close(Track& track, Fate fate);
  bool has_room(const Track& track, std::size_t bytes) const;

  const std::size_t most_waiting_;
  std::uint64_t used_ = 0;  // bytes of all records in the folder; the thread's own

  struct Counters {
    std::atomic<std::uint64_t> bytes, begun, ended, full, too_slow, failed;
  };
  Counters counters_{};

  std::mutex mutex_;
  std::condition_variable_any filled_;
  std::deque<Item> queue_;   // under mutex_
  std::size_t waiting_ = 0;  // bytes in the queue; under mutex_
  std::jthread thread_;      // last: ends first; begins with the first record
};

}  // namespace amalgam::record
