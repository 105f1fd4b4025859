#include "codec/jpeg_metadata.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace amalgam::codec {
namespace {

constexpr std::byte kPrefix{0xFF}, kStartOfScan{0xDA}, kApp0{0xE0}, kApp1{0xE1}, kApp2{0xE2};

// A whole segment with its marker, or nothing at the end of the header.
std::span<const std::byte> segment_at(std::span<const std::byte> jpeg, std::size_t at) {
  if (jpeg.size() - at < 4 || jpeg[at + 1] == kStartOfScan) return {};
  const std::size_t length =
      std::to_integer<std::size_t>(jpeg[at + 2]) * 256 + std::to_integer<std::size_t>(jpeg[at + 3]);
  return jpeg.subspan(at, std::min(2 + length, jpeg.size() - at));
}

bool is_metadata(std::span<const std::byte> segment) {
  using namespace std::string_view_literals;
  constexpr std::array kApp1Names{"Exif\0"sv, "http://ns.adobe.com/xap/1.0/\0"sv};
  constexpr std::array kApp2Names{"ICC_PROFILE\0"sv};
  const auto content = segment.subspan(4);
  const std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
  const auto begins = [&](std::string_view name) { return text.starts_with(name); };
  if (segment[1] == kApp1) return std::any_of(kApp1Names.begin(), kApp1Names.end(), begins);
  return segment[1] == kApp2 && std::any_of(kApp2Names.begin(), kApp2Names.end(), begins);
}

}  // namespace

std::vector<std::byte> jpeg_metadata(std::span<const std::byte> jpeg) {
  std::vector<std::byte> metadata;
  std::size_t at = 2;
  while (at < jpeg.size()) {
    // Stray bytes and fill bytes may stand before a marker.
    const bool is_marker = at + 1 < jpeg.size() && jpeg[at] == kPrefix && jpeg[at + 1] != kPrefix &&
                           jpeg[at + 1] != std::byte{0};
    if (!is_marker) {
      ++at;
      continue;
    }
    const auto segment = segment_at(jpeg, at);
    if (segment.size() < 4) break;
    if (is_metadata(segment)) metadata.insert(metadata.end(), segment.begin(), segment.end());
    at += segment.size();
  }
  return metadata;
}

void insert_metadata(std::vector<std::byte>& jpeg, std::span<const std::byte> metadata) {
  std::size_t at = 2;
  const auto first = segment_at(jpeg, at);
  if (first.size() >= 4 && first[1] == kApp0) at += first.size();
  jpeg.insert(jpeg.begin() + static_cast<std::ptrdiff_t>(at), metadata.begin(), metadata.end());
}

}  // namespace amalgam::codec
