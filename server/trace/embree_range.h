// How far from the world's origin rays may start, so that Embree can still count.
//
// Embree traces a ray in the space of each instance that it comes near, and ends the process
// (Debian's build asserts) if the ray's start is beyond 1.8e18 there. In the space of an instance a
// nanometre wide every distance is 1e9 times as large.
#pragma once

#include <glm/mat4x4.hpp>

namespace amalgam::trace {

// Of any coordinate of a ray's start, metres; whatever the instances.
inline constexpr double kFarthestStart = 1e12;

// Metres. An instance that leaves rays less than this is not traced.
inline constexpr double kLeastRange = 1e5;

// The largest coordinate that a ray's start may have, metres, at most kFarthestStart; negative or
// NaN if there is none.
double start_range(const glm::mat4& world_from_mesh);

inline bool is_traceable(const glm::mat4& world_from_mesh) {
  return start_range(world_from_mesh) >= kLeastRange;
}

}  // namespace amalgam::trace
