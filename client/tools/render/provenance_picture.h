// A frame's provenance as a picture for people.
#pragma once

#include <filesystem>

#include "core/provenance.h"

namespace amalgam::tools {

// Writes a picture (.png, .jpg) with the mean of the sources' colors, weighted by their shares, and
// a legend below. Pixels without provenance are white. Throws std::runtime_error.
void write_provenance_picture(const core::ProvenanceImage& provenance,
                              const std::filesystem::path& file);

}  // namespace amalgam::tools
