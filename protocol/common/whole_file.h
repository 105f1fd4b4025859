// Files that are there whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace amalgam::common {

// write() gets the path of a file beside the target, with the same extension, which then takes the
// target's name. If write() throws, it is removed and the target is as it was. What is no regular
// file (/dev/stdout, a pipe) is written directly. Throws what write() throws, and
// std::runtime_error.
void write_whole_file(const std::filesystem::path& target,
                      const std::function<void(const std::filesystem::path&)>& write);

// The same with these bytes. Throws std::runtime_error naming the target.
void write_whole_file(const std::filesystem::path& target, std::string_view bytes);

}  // namespace amalgam::common
