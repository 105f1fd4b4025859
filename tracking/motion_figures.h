// Measures the effect of smoothing on a stream of poses: how much it reduces jitter, and how much
// lag it adds.
//
// Jitter: the root mean square of the second difference of successive values. It is 0 for motion at
// a constant speed, and sqrt(6) s for white noise of deviation s.
//
// Lag: the time t by which the smoothed motion, extrapolated with its velocity v, fits the raw
// motion best. It minimises sum |raw - smoothed - t v|^2, so t = sum v.(raw - smoothed) / sum v.v.
// Fast motion counts most, as it does for the eye. At a constant speed t is the filter's
// steady-state lag.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace amalgam::tracking {

struct MotionFigures {
  double raw_jitter = 0.0, smoothed_jitter = 0.0;  // metres, or radians
  double lag = 0.0;                                // seconds; 0 if nothing moved
};

// One kind of motion of any number of markers. Keeps only sums, so that it may run for days.
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

}  // namespace amalgam::tracking
