// Whether a replay gives what was recorded, byte for byte.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "client/tools/load/recorded_session.h"

namespace amalgam::load {

// What decides the bytes and is not as it was: "scene_hash: 12ab, recorded 34cd", ... Empty if all
// is equal.
std::vector<std::string> differences(const protocol::Fingerprint& recorded,
                                     const protocol::Fingerprint& now);

class ReplayComparison {
 public:
  // folder: for both JPEGs of each frame that differs; empty: nowhere. Throws std::runtime_error if
  // it cannot be made. The session outlives the comparison.
  ReplayComparison(const RecordedSession& session, std::filesystem::path folder);

  void welcomed(const protocol::Welcome& welcome);
  // The server's answer to the frame with this number. A number that there is not is ignored.
  void answered(std::uint64_t number, const protocol::Composite& composite);
  void refused(std::uint64_t number, const protocol::Error& error);
  void remark(const std::string& text) { remarks_.insert(text); }

  // all_again: whether a frame that is missing is one too few.
  bool is_good(bool all_again) const;
  std::string to_json() const;

 private:
  const RecordedFrame* find(std::uint64_t number);
  void count(const RecordedFrame& frame, bool equal);
  void write(const RecordedFrame& frame, const std::string* now) const;
  std::uint64_t missing() const { return recorded_ - equal_ - different_; }

  const RecordedSession& session_;
  const std::filesystem::path folder_;
  std::uint64_t recorded_ = 0, equal_ = 0, different_ = 0, only_now_ = 0;
  const RecordedFrame* first_different_ = nullptr;
  std::set<std::uint64_t> seen_;
  std::vector<std::string> differences_;
  std::set<std::string> remarks_;
};

}  // namespace amalgam::load
