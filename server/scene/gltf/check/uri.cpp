#include "scene/gltf/check/uri.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace amalgam::scene {
namespace {

bool is_base64(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' ||
         c == '/';
}

// The number of bytes that a base64 text decodes to; fails if it is not one.
long long base64_bytes(const JsonCursor& at, std::string_view text) {
  std::size_t padding = 0;
  while (padding < 2 && !text.empty() && text.back() == '=') {
    text.remove_suffix(1);
    ++padding;
  }
  if ((text.size() + padding) % 4 != 0 || !std::all_of(text.begin(), text.end(), is_base64)) {
    at.fail("is not valid base64");
  }
  return static_cast<long long>(text.size() * 3 / 4);
}

// The base64 text behind "data:<one of the types>;base64,".
template <std::size_t N>
std::string_view data_of(const JsonCursor& at, const std::array<std::string_view, N>& types) {
  const std::string_view uri = at.string();
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) at.fail("is a data URI without data");
  std::string_view header = uri.substr(5, comma - 5);
  constexpr std::string_view kBase64 = ";base64";
  if (!header.ends_with(kBase64)) at.fail("is a data URI that is not base64");
  header.remove_suffix(kBase64.size());
  if (std::find(types.begin(), types.end(), header) == types.end()) {
    at.fail("has media type '" + std::string(header.substr(0, 40)) + "', which does not fit");
  }
  return uri.substr(comma + 1);
}

void check_relative(const JsonCursor& at) {
  const std::string name = decode_percent(at);
  if (name.empty()) at.fail("is empty");
  const std::size_t colon = name.find(':'), slash = name.find('/');
  if (colon != std::string::npos && (slash == std::string::npos || colon < slash)) {
    at.fail("has a scheme; only files beside the scene are read");
  }
  if (name[0] == '/' || name[0] == '\\') at.fail("is an absolute path");
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

bool is_data_uri(const std::string& uri) {
  return uri.starts_with("data:");
}

std::string decode_percent(const JsonCursor& uri) {
  const std::string& text = uri.string();
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    if (c == '%') {
      const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
      const int low = high >= 0 ? hex_digit(text[i + 2]) : -1;
      if (low < 0) uri.fail("has a broken % escape");
      c = static_cast<char>(high * 16 + low);
      i += 2;
    }
    if (c == '\0') uri.fail("contains a zero byte");
    decoded.push_back(c);
  }
  return decoded;
}

void check_buffer_uri(const JsonCursor& uri, long long byte_length) {
  if (!is_data_uri(uri.string())) return check_relative(uri);
  constexpr std::array<std::string_view, 2> kTypes{"application/octet-stream",
                                                   "application/gltf-buffer"};
  const long long bytes = base64_bytes(uri, data_of(uri, kTypes));
  if (bytes != byte_length) {
    uri.fail("holds " + std::to_string(bytes) + " bytes, but byteLength says " +
             std::to_string(byte_length));
  }
}

void check_image_uri(const JsonCursor& uri) {
  if (!is_data_uri(uri.string())) return check_relative(uri);
  constexpr std::array<std::string_view, 2> kTypes{"image/png", "image/jpeg"};
  base64_bytes(uri, data_of(uri, kTypes));
}

}  // namespace amalgam::scene
