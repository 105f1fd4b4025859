// The shared secret that admits clients: read from a file, compared so that the time taken tells
// nothing about it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace amalgam::net {

// The file's content without white space at its ends. Throws std::runtime_error, never quoting the
// content, if the file cannot be read, is empty or holds more than protocol::kMaxTokenBytes.
std::string read_token_file(const std::filesystem::path& path);

bool tokens_equal(std::string_view given, std::string_view expected);

}  // namespace amalgam::net
