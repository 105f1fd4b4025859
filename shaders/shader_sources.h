// The shader files of this folder, embedded into the program, with their #include lines resolved.
#pragma once

#include <string_view>

namespace amalgam::shaders {

// The text of a file, by its name ("write_mask.frag"). Throws std::out_of_range if there is none.
std::string_view source(std::string_view file);

}  // namespace amalgam::shaders
