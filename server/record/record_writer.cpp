#include "record/record_writer.h"

#include <csignal>
#include <exception>
#include <utility>

#include "common/log.h"
#include "protocol/framing.h"
#include "record/record_folder.h"

namespace amalgam::record {
namespace {

// Kept free in each file, so that a full record can still say that it is full.
constexpr std::size_t kEndBytes = 64;

std::string end_record(const Track& track, Fate fate) {
  using protocol::RecordEnd;
  protocol::SessionRecord record = record_now(track);
  record.mutable_end()->set_reason(fate == Fate::Full       ? RecordEnd::FULL
                                   : fate == Fate::TooSlow  ? RecordEnd::TOO_SLOW
                                   : fate == Fate::Reloaded ? RecordEnd::RELOADED
                                                            : RecordEnd::CLOSED);
  return protocol::encode(record);
}

void warn(const Track& track, const std::string& why) {
  common::log_warn(common::LogKind::Session, "session " + std::to_string(track.session) +
                                                 ": its record ends, the session goes on: " + why);
}

// A limit on the size of files is an error of write() like any other, and not the process's end.
void survive_file_limits() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGXFSZ);
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

}  // namespace

void RecordWriter::append(const std::shared_ptr<Track>& track, std::string bytes) {
  if (track->fate != Fate::On) return;
  {
    const std::lock_guard lock(mutex_);
    if (waiting_ + bytes.size() <= most_waiting_) return put({track, std::move(bytes)});
  }
  ++counters_.too_slow;
  warn(*track, "the disk does not keep up");
  end(track, Fate::TooSlow);
}

void RecordWriter::end(const std::shared_ptr<Track>& track, Fate fate) {
  Fate before = Fate::On;
  if (!track->fate.compare_exchange_strong(before, fate)) return;
  const std::lock_guard lock(mutex_);
  put({track, "", fate});
}

void RecordWriter::put(Item item) {
  if (!thread_.joinable()) {
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }
  waiting_ += item.bytes.size();
  queue_.push_back(std::move(item));
  filled_.notify_one();
}

WriterCounts RecordWriter::counts() const {
  return {.bytes = counters_.bytes,
          .begun = counters_.begun,
          .ended = counters_.ended,
          .full = counters_.full,
          .too_slow = counters_.too_slow,
          .failed = counters_.failed};
}

// --- on the writer's thread ---

void RecordWriter::run(const std::stop_token& stop) {
  survive_file_limits();
  for (;;) {
    std::unique_lock lock(mutex_);
    if (!filled_.wait(lock, stop, [this] { return !queue_.empty(); })) return;
    const Item item = std::move(queue_.front());
    queue_.pop_front();
    lock.unlock();
    item.bytes.empty() ? close(*item.track, item.end) : write(*item.track, item.bytes);
    lock.lock();
    // Only now, so that what is being written counts as waiting too.
    waiting_ -= item.bytes.size();
  }
}

bool RecordWriter::has_room(const Track& track, std::size_t bytes) const {
  const std::uint64_t size = track.file ? track.file->size() : 0;
  return size + bytes + kEndBytes <= track.options.session_bytes &&
         used_ + bytes + kEndBytes <= track.options.total_bytes;
}

void RecordWriter::write(Track& track, const std::string& bytes) {
  if (track.over) return;
  try {
    if (!track.begun) begin(track);
    if (!has_room(track, bytes.size())) return close(track, Fate::Full);
    if (!track.file) {
      track.file = std::make_unique<RecordFile>(record_path(track.options.folder, track.session));
    }
    append_now(track, bytes);
  } catch (const std::exception& error) {
    warn(track, error.what());
    close(track, Fate::Failed);
  }
}

void RecordWriter::begin(Track& track) {
  track.begun = true;
  ++counters_.begun;
  used_ = bytes_of_records(track.options.folder);  // an operator may have tidied up
}

void RecordWriter::append_now(Track& track, const std::string& bytes) {
  if (const auto error = track.file->append(bytes)) throw std::system_error(error, "write");
  track.bytes += bytes.size();
  used_ += bytes.size();
  counters_.bytes += bytes.size();
}

void RecordWriter::close(Track& track, Fate fate) {
  if (!track.begun || std::exchange(track.over, true)) return;
  ++counters_.ended;
  switch (fate) {
    case Fate::Full:
      ++counters_.full;
      track.fate = fate;
      warn(track, "there is no room for more");
      break;
    case Fate::Failed:
      ++counters_.failed;
      track.fate = fate;
      break;
    default:
      break;  // it was the session's thread that ended it
  }
  try {
    if (track.file && fate != Fate::Failed) append_now(track, end_record(track, fate));
  } catch (const std::system_error&) {
    // The record is as whole without its last word.
  }
  track.file.reset();
}

}  // namespace amalgam::record
