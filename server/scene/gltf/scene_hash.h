// Whether two scenes are the same, by their files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace amalgam::scene {

// A .gltf or .glb file and what it refers to: its buffers, pictures and environment that are files.
// Throws SceneError if it is no such file. What is missing is left out, as load_scene() tells it.
std::vector<std::filesystem::path> files_of_scene(const std::filesystem::path& path);

// SHA-256 of the sizes and bytes of those files, in hexadecimal digits. Throws SceneError.
std::string scene_hash(const std::filesystem::path& path);

}  // namespace amalgam::scene
