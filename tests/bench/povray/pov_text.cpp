#include "bench/povray/pov_text.h"

#include <cstdio>

namespace amalgam::bench {

std::string pov_vector(const glm::dvec3& v) {
  char text[96];
  std::snprintf(text, sizeof text, "<%.9g, %.9g, %.9g>", v.x, v.y, v.z);
  return text;
}

}  // namespace amalgam::bench
