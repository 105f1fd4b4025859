// What a file of the page is, by the end of its name.
#pragma once

#include <string_view>

namespace amalgam::web {

// Browsers refuse modules and WebAssembly of another type.
std::string_view content_type(std::string_view path);

}  // namespace amalgam::web
