// What smoothing does to a stream of poses, in two figures: how much less it trembles, and how much
// later it comes.
//
// Jitter: the root mean square of the second difference of successive values, which motion at a
// constant speed leaves at 0. For white noise of deviation s it is sqrt(6) s.
//
// Lag: the time by which the smoothed motion, moved along its own velocity, would meet the raw one
// best: the t that minimises sum |raw - smoothed - t v|^2, which is sum v.(raw - smoothed) /
// sum v.v, with v the smoothed velocity. Fast motion thus counts most, as it does for the eye; at a
// constant speed it is the filter's steady-state lag.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "common/pose.h"

namespace amalgam::client {

struct MotionFigures {
  double raw_jitter = 0.0, smoothed_jitter = 0.0;  // metres, or radians
  double lag = 0.0;                                // seconds; 0 if nothing moved
};

// One kind of motion of any number of markers: sums only, so that it may run for days.
class MotionMeter {
 public:
  // Second differences of the raw and of the smoothed values.
  void add_jitter(const glm::dvec3& raw, const glm::dvec3& smoothed);
  // offset: raw - smoothed; velocity: of the smoothed motion, per second.
  void add_lag(const glm::dvec3& offset, const glm::dvec3& velocity);
  MotionFigures figures() const;

 private:
  double raw_ = 0.0, smoothed_ = 0.0;
  std::uint64_t count_ = 0;
  double along_ = 0.0, speed_ = 0.0;
};

}  // namespace amalgam::client
