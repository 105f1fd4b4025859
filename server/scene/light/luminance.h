// The luminance of linear Rec. 709 colors (ITU-R BT.709, item 3.2).
#pragma once

#include <glm/vec3.hpp>

namespace amalgam::scene {

inline double luminance(const glm::dvec3& rgb) {
  return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z;
}

inline float luminance(const glm::vec3& rgb) {
  return 0.2126f * rgb.x + 0.7152f * rgb.y + 0.0722f * rgb.z;
}

}  // namespace amalgam::scene
