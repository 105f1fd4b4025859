// Pages of markers as files that print at true size.
#pragma once

#include <filesystem>
#include <string>

#include "sheet/marker_sheet.h"

namespace amalgam::sheet {

// The bytes of a PDF. Throws std::runtime_error if memory is missing.
std::string pdf_of(const MarkerSheet& sheet);

// By the name's end: .pdf, or .svg for a single page. Throws std::runtime_error for another end,
// several pages as SVG, and files that cannot be written.
void write_sheet(const std::filesystem::path& file, const MarkerSheet& sheet);

}  // namespace amalgam::sheet
