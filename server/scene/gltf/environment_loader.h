// Environment maps from files: OpenEXR and Radiance (.hdr) as scene-linear radiance, JPEG and PNG
// as low dynamic range.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/light/environment.h"

namespace amalgam::scene {

// The name's extension gives the format (.exr, .hdr, .jpg, .jpeg, .png). High-dynamic-range values
// are sanitised, with a note of the replacements. Throws SceneError naming the file.
Environment load_environment(const std::filesystem::path& path, std::vector<std::string>& notes);

// 8-bit sRGB texels as a low-dynamic-range map, display-linear.
Environment environment_from_ldr(const common::ImageRgba8& picture);

}  // namespace amalgam::scene
