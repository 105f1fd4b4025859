// Bytes as hexadecimal digits, as hashes are written.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace amalgam::common {

inline std::string hex_text(std::span<const unsigned char> bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  text.reserve(2 * bytes.size());
  for (const unsigned char byte : bytes) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

}  // namespace amalgam::common
