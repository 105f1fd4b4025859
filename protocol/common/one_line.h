// Text from files and clients as one line that is safe to print.
#pragma once

#include <string>
#include <string_view>

namespace amalgam::common {

// Control characters become spaces, also those of Unicode's second block (U+0080 to U+009F), of
// which terminals obey some. Line breaks at the end are left out. Other bytes stay, UTF-8 or not.
std::string one_line(std::string_view text);

}  // namespace amalgam::common
