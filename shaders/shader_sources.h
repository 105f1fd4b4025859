// The shader files of this folder, embedded into the program with their #include lines resolved.
#pragma once

#include <string_view>

namespace amalgam::shaders {

// The text of a file, by name ("write_mask.frag"). Throws std::out_of_range for an unknown name.
std::string_view source(std::string_view file);

}  // namespace amalgam::shaders
