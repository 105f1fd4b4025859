// Runs POV-Ray, which is optional: apt-get install povray.
#pragma once

#include <filesystem>
#include <string>

namespace amalgam::bench {

bool has_povray();

// "3.7.0.10", or what it says instead.
std::string povray_version();

// Renders without anti-aliasing to picture (.png); returns what POV-Ray says it traced for, without
// reading the scene. Throws std::runtime_error with POV-Ray's last lines if it fails.
double povray_trace_milliseconds(const std::filesystem::path& scene,
                                 const std::filesystem::path& picture, int width, int height,
                                 int threads);

}  // namespace amalgam::bench
