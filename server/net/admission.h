// Whether one more session can be served. Frames of those that are must stay in time, so a session
// is refused while its share of the renderer or its memory is missing. Independent of sockets.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "common/camera_model.h"
#include "frame/frame.h"
#include "net/server_config.h"

namespace amalgam::net {

class Admission {
 public:
  explicit Admission(const AdmissionLimits& limits) : limits_(limits) {}

  struct Busy {
    std::chrono::milliseconds retry_after{0};
    const char* reason = "";  // for people
    const char* label = "";   // for metrics
  };

  // load: with the sessions that are open now. Takes the memory, if the session is admitted.
  std::optional<Busy> admit(const common::CameraModel& camera, const frame::ServiceLoad& load);
  // Memory that a session wants beyond its own; false, and none taken, if there is none.
  bool take(std::uint64_t bytes);
  void give_back(std::uint64_t bytes) { memory_ -= bytes; }
  // A session that was admitted is over.
  void leave(const common::CameraModel& camera);
  void set_limits(const AdmissionLimits& limits) { limits_ = limits; }
  std::uint64_t memory() const { return memory_; }
  // What is left of load and memory, whichever is less: 0..1.
  double free_part(const frame::ServiceLoad& load) const;

 private:
  AdmissionLimits limits_;
  std::uint64_t memory_ = 0;
  std::uint64_t sessions_ = 0;
};

// Bytes that a session is expected to need: three messages of the largest size, and what its view
// usually keeps from frame to frame. While nothing moves a view may keep more for a time, at most
// frame::StillView::kMostBytes (64 MiB).
std::uint64_t memory_of_session(const common::CameraModel& camera);

}  // namespace amalgam::net
