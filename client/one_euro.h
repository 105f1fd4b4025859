// The One-Euro filter: a low-pass whose cut-off rises with speed, so that what rests does not
// tremble and what moves does not drag [Casiez, Roussel & Vogel, CHI 2012].
//
// Cut-off = min_cutoff + beta * speed, in Hz; the speed is that of successive raw values, itself
// low-passed at 1 Hz. At a constant speed the filtered value is late by 1 / (2 pi cut-off) seconds.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace amalgam::client {

struct OneEuroOptions {
  double min_cutoff = 1.0;  // Hz, above 0
  double beta = 0.0;        // Hz per m/s for positions, Hz per rad/s for rotations; 0 or more
};

// The weight of the newest value in an exponential low-pass; seconds since the last one.
double smoothing_weight(double cutoff_hz, double seconds);

// Turns by a rotation vector (axis times angle, radians; the shorter way) and back.
glm::dvec3 rotation_vector(const glm::dquat& rotation);

// A position in metres; one cut-off for all three coordinates, so that paths keep their shape.
class OneEuroPosition {
 public:
  explicit OneEuroPosition(const OneEuroOptions& options) : options_(options) {}
  // seconds since the previous value, above 0; ignored for the first one, which passes unchanged.
  glm::dvec3 filter(const glm::dvec3& raw, double seconds);

 private:
  OneEuroOptions options_;
  std::optional<glm::dvec3> last_raw_;
  glm::dvec3 filtered_{}, velocity_{};
};

// A rotation as a unit quaternion, filtered along the great arc.
class OneEuroRotation {
 public:
  explicit OneEuroRotation(const OneEuroOptions& options) : options_(options) {}
  glm::dquat filter(const glm::dquat& raw, double seconds);

 private:
  OneEuroOptions options_;
  std::optional<glm::dquat> last_raw_;
  glm::dquat filtered_{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 velocity_{};  // rad/s
};

}  // namespace amalgam::client
