// Random numbers that are the same on every machine: those of the standard library's distributions
// are not.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>

namespace amalgam::extreme {

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}

  // In [low, high).
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  // The logarithm is uniform.
  double decades(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }
  int integer(int low, int high) {  // both may come
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool happens(double probability) { return between(0.0, 1.0) < probability; }

  glm::dvec3 in_box(double half_side) {
    const double x = between(-half_side, half_side), y = between(-half_side, half_side);
    return {x, y, between(-half_side, half_side)};
  }
  glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 v = in_box(1.0);
      const double length = glm::length(v);
      if (length > 0.1 && length < 1.0) return v / length;
    }
  }
  glm::vec3 color(double low, double high) {
    const double r = between(low, high), g = between(low, high);
    return glm::vec3(glm::dvec3(r, g, between(low, high)));
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace amalgam::extreme
