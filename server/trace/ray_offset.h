// Offsets the origins of secondary rays from their surface, so that they do not meet it again.
//
// After Wächter and Binder (A Fast and Robust Method for Avoiding Self-Intersection, Ray Tracing
// Gems, 2019, ch. 6): from the point of the barycentric coordinates, along the geometric normal, by
// a number of units in the last place. Their offset is 256 units of the *point's* coordinates, and
// a fixed length near the origin. It suits any mesh, but glass and mirrors magnify the sideways
// shift of the ray to a fiftieth of a pixel. Here the offset is 32 units of the largest *input*
// coordinate: those of the triangle's corners and of the instance's translation bound the rounding
// error, wherever the point lies. Resolution limit (numerics B2): gaps below 4e-6 of that
// coordinate are skipped.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace amalgam::trace {

inline constexpr double kOffsetUnits = 32.0;

// largest_coordinate: of the triangle's corners and the instance's translation, in the world,
// metres.
inline double offset_height(double largest_coordinate) {
  return kOffsetUnits / (1 << 23) * largest_coordinate;
}

// p: a point on the surface. normal: geometric, unit, of either side. The result lies on the side
// into which the ray leaves.
inline glm::dvec3 offset_from_surface(const glm::dvec3& p, const glm::dvec3& normal,
                                      const glm::dvec3& direction, double height) {
  return p + (glm::dot(normal, direction) < 0.0 ? -height : height) * normal;
}

}  // namespace amalgam::trace
