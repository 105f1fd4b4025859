// Where each pixel's light came from, as a picture for people.
#pragma once

#include <filesystem>

#include "core/provenance.h"

namespace amalgam::tools {

// Writes a picture (.png, .jpg) of the mean of the sources' colors by their shares, with a legend
// below. What nothing was drawn on is white. Throws std::runtime_error.
void write_provenance_picture(const core::ProvenanceImage& provenance,
                              const std::filesystem::path& file);

}  // namespace amalgam::tools
