#include "scene/gltf/scene_folder.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "scene/scene_error.h"

namespace amalgam::scene {

SceneFolder::SceneFolder(const std::filesystem::path& scene_file) {
  std::error_code error;
  folder_ = std::filesystem::canonical(scene_file, error).parent_path();
  if (error) throw SceneError(scene_file.string() + ": " + error.message());
}

std::filesystem::path SceneFolder::resolve(const std::string& name) const {
  std::error_code error;
  const auto path = std::filesystem::canonical(folder_ / name, error);
  if (error) throw SceneError("'" + name + "': " + error.message());
  const auto [inside, rest] =
      std::mismatch(folder_.begin(), folder_.end(), path.begin(), path.end());
  if (inside != folder_.end()) {
    throw SceneError("'" + name + "' lies outside the scene's own folder");
  }
  if (!std::filesystem::is_regular_file(path, error)) {
    throw SceneError("'" + name + "' is not a regular file");
  }
  return path;
}

std::vector<std::byte> read_file(const std::filesystem::path& path, std::size_t max_bytes,
                                 std::size_t wanted) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw SceneError("'" + path.filename().string() + "': " + error.message());
  if (size > max_bytes) {
    throw SceneError("'" + path.filename().string() + "' is larger than " +
                     std::to_string(max_bytes >> 20) + " MiB");
  }
  std::vector<std::byte> bytes(std::min(static_cast<std::size_t>(size), wanted));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file || file.gcount() != static_cast<std::streamsize>(bytes.size())) {
    throw SceneError("'" + path.filename().string() + "' cannot be read");
  }
  return bytes;
}

}  // namespace amalgam::scene
