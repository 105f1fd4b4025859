// The scenes of deploy/scenes/stiff, on which a ray tracer's error falls slowly, with a view of
// each that its hard part fills, and the laws that their pictures must follow.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "common/camera_model.h"
#include "common/pose.h"

namespace amalgam::test_support {

struct StiffScene {
  enum class Kind {
    Corridor,  // two mirrors that face each other
    Stack,     // sheets of glass
    Ball,      // of glass
    Nested,    // a bubble in a liquid in glass
    Lens,
  };
  std::string name;  // "corridor-0.9-1m"
  std::string file;  // path
  Kind kind = Kind::Corridor;
  // Of a corridor, the mirrors' reflectance; of a stack, the number of sheets; of a ball, the index
  // of refraction; otherwise 0.
  double parameter = 0.0;
  double size = 1.0;          // metres: 0.001, 1 or 1000
  common::MarkerPose pose;    // of the world marker; its distance grows with the size
  double focal_length = 1.1;  // image widths

  common::CameraModel camera(int width, int height) const;
};

// All of them: by kind, then by parameter, then by size.
std::vector<StiffScene> stiff_scenes();
// The one of that name. Throws std::out_of_range.
StiffScene stiff_scene(const std::string& name);

// Looks straight into the middle of the corridor or stack, so narrowly that all pixels see the
// same: an endless corridor, and sheets at normal incidence.
common::CameraModel narrow_camera(int side);
common::MarkerPose straight_pose(const StiffScene& scene);

// The radiance inside an endless corridor of any reflectance.
inline constexpr glm::dvec3 kCorridorGlow{0.4, 0.5, 0.3};
// By how much the error grows with each further mirror that a ray may meet (numerics B7).
inline double corridor_error_ratio(double reflectance) {
  return reflectance;
}

// The share of light that passes sheets at normal incidence, reflections between and inside them
// included (numerics B5). A sheet transmits (1 - R) / (1 + R) with R = ((n - 1) / (n + 1))^2.
double stack_transmittance(double index, int sheets);
inline constexpr double kStackIndex = 1.5;

}  // namespace amalgam::test_support
