// The memory that one session's own environments take of what all sessions may need together. While
// a new one is applied there are two.
#pragma once

#include <cstdint>
#include <utility>

#include "net/admission.h"

namespace amalgam::net {

class OwnLight {
 public:
  explicit OwnLight(Admission& admission) : admission_(admission) {}
  ~OwnLight() { leave(); }
  OwnLight(const OwnLight&) = delete;
  OwnLight& operator=(const OwnLight&) = delete;

  // False if there is no memory for another one.
  bool begin(std::uint64_t bytes) {
    if (!admission_.take(bytes)) return false;
    coming_ = bytes;
    return true;
  }
  // The one that was begun, if one was, is applied or given up.
  void end(bool applied) {
    const std::uint64_t bytes = std::exchange(coming_, 0);
    admission_.give_back(applied && bytes > 0 ? std::exchange(kept_, bytes) : bytes);
  }
  // The session is over.
  void leave() { admission_.give_back(std::exchange(coming_, 0) + std::exchange(kept_, 0)); }

  bool exists() const { return kept_ > 0; }

 private:
  Admission& admission_;
  std::uint64_t coming_ = 0, kept_ = 0;  // bytes
};

}  // namespace amalgam::net
