#include "net/admission.h"

#include <algorithm>

namespace amalgam::net {

std::uint64_t memory_of_session(const common::CameraModel& camera) {
  // Measured: kept results of one sample a pixel (frame/still_frame.h), and a waiting composite.
  constexpr std::uint64_t kBytesPerPixel = 32;
  return 3 * std::uint64_t{protocol::kMaxCameraFrameBytes} +
         kBytesPerPixel * static_cast<std::uint64_t>(camera.width) *
             static_cast<std::uint64_t>(camera.height);
}

std::optional<Admission::Busy> Admission::admit(const common::CameraModel& camera,
                                                const frame::ServiceLoad& load) {
  const std::uint64_t memory = memory_of_session(camera);
  if (limits_.memory > 0 && memory_ + memory > limits_.memory) {
    return Busy{protocol::kRetryAfter, "no memory for another session", "memory"};
  }
  const double own = load.seconds_per_pixel * static_cast<double>(camera.width) *
                     static_cast<double>(camera.height) * load.frames_per_second;
  // Alone, a session gets what there is.
  if (limits_.load > 0.0 && sessions_ > 0 && load.demand + own > limits_.load) {
    // The more there is too much, the longer it takes until enough have left.
    const double excess = (load.demand + own) / limits_.load;
    constexpr double kMostTimes = 15.0;
    return Busy{std::chrono::duration_cast<std::chrono::milliseconds>(protocol::kRetryAfter *
                                                                      std::min(excess, kMostTimes)),
                "the renderer has no time for another session", "load"};
  }
  memory_ += memory;
  ++sessions_;
  return std::nullopt;
}

double Admission::free_part(const frame::ServiceLoad& load) const {
  const double time = 1.0 - load.demand / (limits_.load > 0.0 ? limits_.load : 1.0);
  const double memory =
      limits_.memory > 0 ? 1.0 - static_cast<double>(memory_) / static_cast<double>(limits_.memory)
                         : 1.0;
  return std::clamp(std::min(time, memory), 0.0, 1.0);
}

bool Admission::take(std::uint64_t bytes) {
  if (limits_.memory > 0 && memory_ + bytes > limits_.memory) return false;
  memory_ += bytes;
  return true;
}

void Admission::leave(const common::CameraModel& camera) {
  memory_ -= memory_of_session(camera);
  --sessions_;
}

}  // namespace amalgam::net
