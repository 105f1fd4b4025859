// The numbers that C++ and GLSL share, as lines of GLSL. Each is defined once, in C++; shaders use
// the same name.
#pragma once

#include <string>

namespace amalgam::gl {

// "const uint kMaxLights = 512u;" and so on: the beginning of every shader.
std::string shader_constants();

}  // namespace amalgam::gl
