#include "common/token_file.h"

#include <sstream>
#include <stdexcept>

#include "common/utf8.h"
#include "common/whole_file.h"

namespace amalgam::common {
namespace {

constexpr std::size_t kMaxFileBytes = 1024 * 1024;  // thousands of tokens

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what) {
  throw std::runtime_error("the token file " + path.string() + " " + what);
}

std::string read(const std::filesystem::path& path) {
  std::string text;
  try {
    text = read_whole_file(path, kMaxFileBytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string("the token file ") + error.what());
  }
  if (!is_utf8(text)) fail(path, "is not UTF-8");
  return text;
}

std::vector<TokenLine> parse(const std::filesystem::path& path, std::size_t max_bytes) {
  std::vector<TokenLine> lines;
  std::istringstream text(read(path));
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    std::istringstream words(line);
    TokenLine parsed{.number = number, .token = {}, .rights = {}};
    if (!(words >> parsed.token)) continue;
    if (parsed.token.size() > max_bytes) {
      fail(path, "holds a token of more than " + std::to_string(max_bytes) + " bytes");
    }
    for (std::string right; words >> right;) parsed.rights.push_back(right);
    lines.push_back(std::move(parsed));
  }
  if (lines.empty()) fail(path, "is empty");
  return lines;
}

}  // namespace

std::string read_token_file(const std::filesystem::path& path, std::size_t max_bytes) {
  std::vector<TokenLine> lines = parse(path, max_bytes);
  if (lines.size() > 1 || !lines.front().rights.empty()) {
    fail(path, "holds more than one word; a client's holds its token alone");
  }
  return std::move(lines.front().token);
}

std::vector<TokenLine> read_token_lines(const std::filesystem::path& path, std::size_t max_bytes) {
  namespace fs = std::filesystem;
  std::error_code ec;
  const fs::perms permissions = fs::status(path, ec).permissions();
  if (!ec && (permissions & fs::perms::others_all) != fs::perms::none) {
    fail(path, "may be used by everybody; chmod o= makes it a secret");
  }
  return parse(path, max_bytes);
}

}  // namespace amalgam::common
