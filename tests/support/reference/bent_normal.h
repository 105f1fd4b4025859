// The shading normal of a specular surface, bent so that reflections stay above the triangle, and
// refracted rays bent so that they stay below it (numerics B10; the method for reflections is
// Cycles' ensure_valid_specular_reflection).
#pragma once

#include "support/reference/vectors.h"

namespace amalgam::reference {

// All unit: geometric faces the viewer, to_viewer points away from the surface.
inline Vec3 bend_normal(const Vec3& shading, const Vec3& geometric, const Vec3& to_viewer) {
  const double cosine = glm::dot(shading, to_viewer);
  const Vec3 mirrored = 2.0 * cosine * shading - to_viewer;
  const double threshold = std::min(0.9 * glm::dot(geometric, to_viewer), 0.01);
  const double height = glm::dot(geometric, mirrored);
  if (cosine > 0.0 && height >= threshold) return shading;
  const Vec3 lifted = glm::normalize(mirrored + (threshold - height) * geometric);
  return glm::normalize(to_viewer + lifted);
}

// A refracted ray, at least a hundred-thousandth of its length below the triangle. geometric faces
// the viewer.
inline Vec3 sink_refracted(const Vec3& refracted, const Vec3& geometric) {
  const double depth = -glm::dot(geometric, refracted);
  const double missing = std::max(0.0, 1e-5 - depth);
  return missing == 0.0 ? refracted : glm::normalize(refracted - missing * geometric);
}

}  // namespace amalgam::reference
