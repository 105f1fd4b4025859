#include "common/token_file.h"

#include <fstream>
#include <stdexcept>
#include <string_view>

namespace amalgam::common {

std::string read_token_file(const std::filesystem::path& path, std::size_t max_bytes) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read the token file " + path.string());
  // One byte more than allowed shows that there is more, whatever the size of the file.
  std::string text(max_bytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > max_bytes) {
    throw std::runtime_error("the token file " + path.string() + " holds more than " +
                             std::to_string(max_bytes) + " bytes");
  }
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == std::string::npos) {
    throw std::runtime_error("the token file " + path.string() + " is empty");
  }
  return text.substr(begin, text.find_last_not_of(kSpace) - begin + 1);
}

}  // namespace amalgam::common
