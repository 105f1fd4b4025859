// The reference computes everything in double: its vector types and the helpers that every file
// needs.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>

namespace amalgam::reference {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Color = glm::dvec3;

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline double largest_channel(const Color& color) {
  return std::max({color.r, color.g, color.b});
}

inline Vec3 transform_point(const glm::dmat4& target_from_source, const Vec3& point) {
  return Vec3(target_from_source * Vec4(point, 1.0));
}

}  // namespace amalgam::reference
