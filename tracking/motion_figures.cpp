#include "tracking/motion_figures.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace amalgam::tracking {

void MotionMeter::add_jitter(const glm::dvec3& raw, const glm::dvec3& smoothed) {
  raw_ += glm::dot(raw, raw);
  smoothed_ += glm::dot(smoothed, smoothed);
  ++count_;
}

void MotionMeter::add_lag(const glm::dvec3& offset, const glm::dvec3& velocity) {
  along_ += glm::dot(velocity, offset);
  speed_ += glm::dot(velocity, velocity);
}

MotionFigures MotionMeter::figures() const {
  MotionFigures figures;
  if (count_ > 0) {
    figures.raw_jitter = std::sqrt(raw_ / static_cast<double>(count_));
    figures.smoothed_jitter = std::sqrt(smoothed_ / static_cast<double>(count_));
  }
  if (speed_ > 0) figures.lag = along_ / speed_;
  return figures;
}

}  // namespace amalgam::tracking
