#include "trace/embree_range.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

namespace amalgam::trace {
namespace {

constexpr double kEmbreesRange = 1e18;

double largest_element(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

double start_range(const glm::mat4& world_from_mesh) {
  const glm::dmat3 mesh_from_world = glm::inverse(glm::dmat3(world_from_mesh));
  // The most by which the largest coordinate can grow: the largest sum of a row.
  glm::dvec3 sums(0.0);
  for (int column = 0; column < 3; ++column) sums += glm::abs(mesh_from_world[column]);
  const double from_instance = kEmbreesRange / largest_element(sums);
  return std::min(kFarthestStart, from_instance - largest_element(glm::dvec3(world_from_mesh[3])));
}

}  // namespace amalgam::trace
