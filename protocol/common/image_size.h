// An image's size as people write it on a command line.
#pragma once

#include <glm/vec2.hpp>
#include <string>

namespace amalgam::common {

// "800x600", pixels, sides of 1 to max_side. Throws std::runtime_error.
glm::ivec2 parse_image_size(const std::string& text, int max_side);

}  // namespace amalgam::common
