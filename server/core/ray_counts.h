// How many rays of each kind a frame took: the machine-independent measure of what tracing costs.
#pragma once

#include <cstdint>

namespace amalgam::core {

struct RayCounts {
  std::uint64_t primary = 0;  // from the camera
  std::uint64_t reflection = 0;
  std::uint64_t refraction = 0;  // passing straight through thin glass included
  std::uint64_t shadow = 0;      // one for each light that may be shaded at a diffuse hit
  std::uint64_t lookup = 0;      // from a real surface to the camera, where depth could not decide

  // Not cast, because nothing has moved since an earlier frame cast them; of all kinds above.
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
