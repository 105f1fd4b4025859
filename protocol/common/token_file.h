// Reads the shared secrets that admit clients from their files, on both sides.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace amalgam::common {

// A client's file: one token, with white space around it at most. Throws std::runtime_error, never
// quoting the content, if the file cannot be read, is empty, holds more than one word, more than
// max_bytes or anything but UTF-8 (which a Hello could not carry).
std::string read_token_file(const std::filesystem::path& path, std::size_t max_bytes);

struct TokenLine {
  int number = 0;  // in the file, from 1
  std::string token;
  std::vector<std::string> rights;  // as written behind it
};

// A server's file: a line for each token, and behind it what it gives a right to. Empty lines count
// for nothing. Throws as above, for a token of more than max_bytes, and if others than owner and
// group may use the file.
std::vector<TokenLine> read_token_lines(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace amalgam::common
