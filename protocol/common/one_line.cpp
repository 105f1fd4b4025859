#include "common/one_line.h"

namespace amalgam::common {

std::string one_line(std::string_view text) {
  while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
  std::string line(text);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto byte = static_cast<unsigned char>(line[i]);
    if (byte < 0x20 || byte == 0x7F) line[i] = ' ';
    // In UTF-8 the second block is 0xC2 and a byte below 0xA0.
    if (byte != 0xC2 || i + 1 == line.size()) continue;
    const auto next = static_cast<unsigned char>(line[i + 1]);
    if (next >= 0x80 && next < 0xA0) line[i] = line[i + 1] = ' ';
  }
  return line;
}

}  // namespace amalgam::common
