// Numbers and vectors as POV-Ray reads them.
#pragma once

#include <glm/vec3.hpp>
#include <string>

namespace amalgam::bench {

std::string pov_vector(const glm::dvec3& v);  // "<1, 2, 3>", nine digits

}  // namespace amalgam::bench
