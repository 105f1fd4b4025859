// Writes pages of markers as files that print at true size.
#pragma once

#include <filesystem>

#include "client/tools/marker/marker_sheet.h"

namespace amalgam::tools {

// By the name's end: .pdf, or .svg for a single page. Throws std::runtime_error for another end,
// several pages as SVG, and files that cannot be written.
void write_sheet(const std::filesystem::path& file, const MarkerSheet& sheet);

}  // namespace amalgam::tools
