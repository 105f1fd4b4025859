// Secondary rays start a little off the surface, so that they do not meet it again.
//
// After Wächter and Binder (A Fast and Robust Method for Avoiding Self-Intersection, Ray Tracing
// Gems, 2019, ch. 6): from a point made of barycentric coordinates, along the geometric normal, by
// a number of units in the last place. They take 256 units of the *point's* coordinates and a fixed
// amount near the origin, which suits any mesh but moves the ray sideways by what glass and mirrors
// magnify to a fiftieth of a pixel. Here it is 32 units of what the point was *computed from*: its
// triangle's corners and the instance's translation bound the rounding error, wherever the point
// itself lies. The resolution limit that this brings (numerics B2): gaps below 4e-6 of the largest
// of those coordinates are skipped.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace amalgam::trace {

inline constexpr double kOffsetUnits = 32.0;

// largest_coordinate: of all that the point was computed from, metres.
inline double offset_height(double largest_coordinate) {
  return kOffsetUnits / (1 << 23) * largest_coordinate;
}

// p: a point on the surface. normal: the geometric one, unit, either side. The origin lies on the
// side that the ray leaves to.
inline glm::dvec3 offset_from_surface(const glm::dvec3& p, const glm::dvec3& normal,
                                      const glm::dvec3& direction, double height) {
  return p + (glm::dot(normal, direction) < 0.0 ? -height : height) * normal;
}

// The same height above the surface, reached along the ray.
inline glm::dvec3 offset_along_ray(const glm::dvec3& p, const glm::dvec3& normal,
                                   const glm::dvec3& direction, double height) {
  constexpr double kMostGrazing = 1e-3;  // flatter rays stay within the height for long anyway
  return p + direction * (height / glm::max(glm::abs(glm::dot(normal, direction)), kMostGrazing));
}

}  // namespace amalgam::trace
