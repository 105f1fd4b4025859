// Rays of a frame by kind: a machine-independent measure of the cost of tracing.
#pragma once

#include <cstdint>

namespace amalgam::core {

struct RayCounts {
  std::uint64_t primary = 0;  // from the camera
  std::uint64_t reflection = 0;
  std::uint64_t refraction = 0;  // including rays straight through thin glass
  std::uint64_t shadow = 0;      // one for each light that may be occluded at a diffuse hit
  // visibility rays from a real surface to the camera, where depth could not decide
  std::uint64_t lookup = 0;

  // Of all kinds above: not cast, because nothing has moved since an earlier frame cast them.
  std::uint64_t reused = 0;

  std::uint64_t cast() const { return primary + reflection + refraction + shadow + lookup; }

  RayCounts& operator+=(const RayCounts& other) {
    primary += other.primary;
    reflection += other.reflection;
    refraction += other.refraction;
    shadow += other.shadow;
    lookup += other.lookup;
    reused += other.reused;
    return *this;
  }
};

}  // namespace amalgam::core
