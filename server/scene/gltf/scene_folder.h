// The folder of a scene: the only place from which a scene can make the server read files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace amalgam::scene {

class SceneFolder {
 public:
  explicit SceneFolder(const std::filesystem::path& scene_file);

  // The real path of a file named relative to the folder. Throws SceneError if it does not exist,
  // is not a regular file or, with links followed, lies outside the folder.
  std::filesystem::path resolve(const std::string& name) const;

 private:
  std::filesystem::path folder_;  // canonical
};

// The file, or its first `wanted` bytes. Throws SceneError if it cannot be read or is larger than
// max_bytes.
std::vector<std::byte> read_file(const std::filesystem::path& path, std::size_t max_bytes,
                                 std::size_t wanted = static_cast<std::size_t>(-1));

}  // namespace amalgam::scene
