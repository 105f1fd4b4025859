// Whether bytes are text that others can read.
#pragma once

#include <string>

namespace amalgam::common {

bool is_utf8(const std::string& text);

}  // namespace amalgam::common
