#include "scene/gltf/check/uri.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace amalgam::scene {
namespace {

// Six bits; -1 for any other character.
int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

// The number of bytes that a base64 text decodes to; fails if it is not one. Padding may be
// missing.
long long base64_bytes(const JsonCursor& at, std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  if (text.size() % 4 == 1 ||
      !std::all_of(text.begin(), text.end(), [](char c) { return base64_digit(c) >= 0; })) {
    at.fail("is not valid base64");
  }
  return static_cast<long long>(text.size() * 3 / 4);
}

constexpr std::string_view kBase64 = ";base64";

std::string_view data_of(const JsonCursor& at) {
  const std::string_view uri = at.string();
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) at.fail("is a data URI without data");
  if (!uri.substr(0, comma).ends_with(kBase64)) at.fail("is a data URI that is not base64");
  return uri.substr(comma + 1);
}

// The media type does not change the bytes.
template <std::size_t N>
void check_media_type(const GltfCheckContext& context, const JsonCursor& at,
                      const std::array<std::string_view, N>& types) {
  std::string_view header = std::string_view(at.string()).substr(5);
  header = header.substr(0, header.find(kBase64));
  if (std::find(types.begin(), types.end(), header) == types.end()) {
    context.note(at, "has media type '" + std::string(header.substr(0, 40)) + "'");
  }
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
      if (low >= 0) {
        c = static_cast<char>(high * 16 + low);
        i += 2;
      }
    }
    if (c == '\0') uri.fail("contains a zero byte");
    decoded.push_back(c);
  }
  return decoded;
}

std::vector<unsigned char> decode_data_uri(const JsonCursor& uri) {
  std::string_view text = data_of(uri);
  while (text.ends_with('=')) text.remove_suffix(1);
  std::vector<unsigned char> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  unsigned int bits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    bits = bits << 6 | static_cast<unsigned int>(base64_digit(text[i]));
    // The last 2, 4 or 6 bits make no byte.
    if (i % 4 != 0) bytes.push_back(static_cast<unsigned char>(bits >> (6 - 2 * (i % 4))));
  }
  return bytes;
}

void check_buffer_uri(const GltfCheckContext& context, const JsonCursor& uri,
                      long long byte_length) {
  if (!is_data_uri(uri.string())) return check_relative(uri);
  constexpr std::array<std::string_view, 2> kTypes{"application/octet-stream",
                                                   "application/gltf-buffer"};
  const long long bytes = base64_bytes(uri, data_of(uri));
  check_media_type(context, uri, kTypes);
  const std::string what = "holds " + std::to_string(bytes) + " bytes, but byteLength says " +
                           std::to_string(byte_length);
  if (bytes < byte_length) uri.fail(what);
  if (bytes > byte_length) context.note(uri, what);
}

void check_image_uri(const GltfCheckContext& context, const JsonCursor& uri) {
  if (!is_data_uri(uri.string())) return check_relative(uri);
  constexpr std::array<std::string_view, 3> kTypes{"image/png", "image/jpeg", "image/webp"};
  base64_bytes(uri, data_of(uri));
  check_media_type(context, uri, kTypes);
}

}  // namespace amalgam::scene
