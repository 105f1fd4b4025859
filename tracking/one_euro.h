// The One-Euro filter: a low-pass whose cut-off rises with speed, which removes jitter at rest and
// lag in motion [Casiez, Roussel & Vogel, CHI 2012].
//
// Cut-off = min_cutoff + beta * speed, in Hz. The speed is that of successive raw values,
// low-passed at 1 Hz. At a constant speed the filtered value lags by 1 / (2 pi cut-off) seconds.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace amalgam::tracking {

struct OneEuroOptions {
  double min_cutoff = 1.0;  // Hz, above 0
  double beta = 0.0;        // Hz per m/s for positions, Hz per rad/s for rotations; 0 or more
};

// The weight of the newest value in an exponential low-pass. seconds: since the last value.
double smoothing_weight(double cutoff_hz, double seconds);

// The rotation vector (axis times angle, radians; the shorter way) of a rotation.
glm::dvec3 rotation_vector(const glm::dquat& rotation);

// Filters a position in metres, with one cut-off for all three coordinates, so that paths keep
// their shape.
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

// Filters a rotation (unit quaternion) along the great arc.
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

}  // namespace amalgam::tracking
