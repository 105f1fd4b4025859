#include "client/synthetic/synthetic_path.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace amalgam::client {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
// In glTF's marker frame (0, 0.03, -0.05): where scenes have their middle.
constexpr glm::dvec3 kTarget{0.0, 0.05, 0.03};

}  // namespace

common::MarkerPose look_at(const glm::dvec3& position_in_marker, const glm::dvec3& target_in_marker,
                           int marker) {
  const glm::dvec3 forward = glm::normalize(target_in_marker - position_in_marker);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
  const glm::dvec3 down = glm::cross(forward, right);
  const glm::dmat3 marker_from_camera(right, down, forward);
  const glm::dmat3 camera_from_marker = glm::transpose(marker_from_camera);
  return {.marker = marker,
          .rotation = glm::normalize(glm::quat_cast(camera_from_marker)),
          .translation = -(camera_from_marker * position_in_marker)};
}

common::MarkerPose synthetic_pose(std::uint64_t frame, int marker) {
  const double turn = 2.0 * std::numbers::pi * static_cast<double>(frame % kSyntheticPeriod) /
                      static_cast<double>(kSyntheticPeriod);
  // Different whole multiples of the turn: smooth, closed, and never at rest in all three at once.
  // From the sheet's bottom edge, to its right.
  const double azimuth = 40.0 * kDegree * std::sin(turn);
  const double elevation = kDegree * (44.0 + 10.0 * std::sin(2.0 * turn + 1.0));
  const double distance = 0.475 + 0.125 * std::cos(turn + 0.7);  // metres
  const glm::dvec3 direction(std::cos(elevation) * std::sin(azimuth),
                             -std::cos(elevation) * std::cos(azimuth), std::sin(elevation));
  return look_at(kTarget + distance * direction, kTarget, marker);
}

}  // namespace amalgam::client
