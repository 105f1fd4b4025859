// Files that are read and written whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace amalgam::common {

// A picture's file in any format. Larger ones would not fit into memory once they are decoded.
inline constexpr std::size_t kMostPictureBytes = std::size_t{512} << 20;

// The file's bytes; it may be a pipe. Throws std::runtime_error with one line that begins with the
// path: for a folder, a file that cannot be read to its end, and one of more than most_bytes, of
// which no more than that is read.
std::string read_whole_file(const std::filesystem::path& path, std::size_t most_bytes);

// write() gets the path of a file beside the target, with the same extension, which then takes the
// target's name. If write() throws, it is removed and the target is as it was. What is no regular
// file (/dev/stdout, a pipe) is written directly. Throws what write() throws, and
// std::runtime_error.
void write_whole_file(const std::filesystem::path& target,
                      const std::function<void(const std::filesystem::path&)>& write);

// The same with these bytes. Throws std::runtime_error naming the target.
void write_whole_file(const std::filesystem::path& target, std::string_view bytes);

// For work that takes long: whether its result can be written there, before it begins. Throws
// std::runtime_error naming the target.
void check_writable(const std::filesystem::path& target);

}  // namespace amalgam::common
