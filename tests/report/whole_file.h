// Files that are there as a whole or not at all: written under a temporary name, then renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace amalgam::report {

// Both throw std::runtime_error with one line that names the file.
void write_whole_file(const std::filesystem::path& path, std::string_view content);
// write(temporary) makes the file; its extension is the path's.
void write_whole_file(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

// Throws std::runtime_error.
std::string read_whole_file(const std::filesystem::path& path);

}  // namespace amalgam::report
