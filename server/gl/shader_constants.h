// The numbers that C++ and GLSL share, as lines of GLSL. Each is written once, in C++; shaders know
// it by the name that it has here.
#pragma once

#include <string>

namespace amalgam::gl {

// "const uint kMaxLights = 512u;" and so on, for every shader to begin with.
std::string shader_constants();

}  // namespace amalgam::gl
