#include "tracking/one_euro.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace amalgam::tracking {
namespace {

constexpr double kVelocityCutoff = 1.0;  // Hz, the paper's choice

glm::dvec3 low_pass(const glm::dvec3& last, const glm::dvec3& raw, double cutoff, double seconds) {
  return glm::mix(last, raw, smoothing_weight(cutoff, seconds));
}

}  // namespace

double smoothing_weight(double cutoff_hz, double seconds) {
  const double time_constant = 1.0 / (2.0 * std::numbers::pi * cutoff_hz);
  return seconds / (seconds + time_constant);
}

glm::dvec3 rotation_vector(const glm::dquat& rotation) {
  const double sign = rotation.w < 0 ? -1.0 : 1.0;
  const glm::dvec3 axis = sign * glm::dvec3(rotation.x, rotation.y, rotation.z);
  const double sine = glm::length(axis);
  if (sine < 1e-12) return 2.0 * axis;
  return axis * (2.0 * std::atan2(sine, sign * rotation.w) / sine);
}

glm::dvec3 OneEuroPosition::filter(const glm::dvec3& raw, double seconds) {
  if (!last_raw_) {
    last_raw_ = filtered_ = raw;
    return raw;
  }
  velocity_ = low_pass(velocity_, (raw - *last_raw_) / seconds, kVelocityCutoff, seconds);
  last_raw_ = raw;
  const double cutoff = options_.min_cutoff + options_.beta * glm::length(velocity_);
  filtered_ = low_pass(filtered_, raw, cutoff, seconds);
  return filtered_;
}

glm::dquat OneEuroRotation::filter(const glm::dquat& raw, double seconds) {
  if (!last_raw_) {
    last_raw_ = filtered_ = raw;
    return raw;
  }
  const glm::dvec3 turned = rotation_vector(raw * glm::conjugate(*last_raw_));
  velocity_ = low_pass(velocity_, turned / seconds, kVelocityCutoff, seconds);
  last_raw_ = raw;
  const double cutoff = options_.min_cutoff + options_.beta * glm::length(velocity_);
  // glm's slerp takes the shorter way.
  filtered_ = glm::normalize(glm::slerp(filtered_, raw, smoothing_weight(cutoff, seconds)));
  return filtered_;
}

}  // namespace amalgam::tracking
