// Reads the shared secret that admits clients from its file, on both sides.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace amalgam::common {

// The file's content without white space at its ends. Throws std::runtime_error, never quoting the
// content, if the file cannot be read, is empty or holds more than max_bytes.
std::string read_token_file(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace amalgam::common
