#include "codec/jpeg_segments.h"

#include <algorithm>
#include <string>

#include "common/log.h"

namespace amalgam::codec {
namespace {

constexpr std::size_t kMarkerBytes = 2;
constexpr std::byte kEscape{0xFF}, kStartOfScan{0xDA}, kEndOfImage{0xD9};
constexpr std::byte kBaselineFrame{0xC0};
constexpr unsigned kFirstRestart = 0xD0;  // the first of eight, which take turns

std::size_t segment_length(std::span<const std::byte> file, std::size_t marker) {
  return std::to_integer<std::size_t>(file[marker + 2]) * 256 +
         std::to_integer<std::size_t>(file[marker + 3]);
}

// Where the first marker of this code stands.
std::size_t find_marker(std::span<const std::byte> file, std::byte code) {
  std::size_t at = kMarkerBytes;
  while (true) {
    AMALGAM_CHECK(at + 4 <= file.size(), std::to_string(at));
    if (file[at + 1] == code) return at;
    at += kMarkerBytes + segment_length(file, at);
  }
}

}  // namespace

SegmentedJpeg::SegmentedJpeg(std::vector<std::byte> file) : file_(std::move(file)) {
  const std::size_t scan = find_marker(file_, kStartOfScan);
  begins_.push_back(scan + kMarkerBytes + segment_length(file_, scan));
  auto at = file_.begin() + static_cast<std::ptrdiff_t>(begins_.front());
  for (bool end = false; !end;) {
    at = std::find(at, file_.end(), kEscape);
    AMALGAM_CHECK(file_.end() - at >= 2, std::to_string(file_.size()));
    const std::byte code = at[1];
    at += kMarkerBytes;
    if (code == std::byte{0}) continue;  // an escaped byte of the code itself
    begins_.push_back(static_cast<std::size_t>(at - file_.begin()));
    end = code == kEndOfImage;
  }
}

JpegSegment SegmentedJpeg::segment(std::size_t index) const {
  AMALGAM_CHECK(index < count(), std::to_string(index) + " of " + std::to_string(count()));
  const std::size_t begin = begins_[index], next = begins_[index + 1];
  return std::span(file_).subspan(begin, next - kMarkerBytes - begin);
}

std::vector<std::byte> join_segments(std::span<const std::byte> head,
                                     std::span<const JpegSegment> segments) {
  std::size_t size = head.size();
  for (const JpegSegment& segment : segments) size += segment.size() + kMarkerBytes;
  std::vector<std::byte> file;
  file.reserve(size);
  file.insert(file.end(), head.begin(), head.end());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    file.insert(file.end(), segments[i].begin(), segments[i].end());
    const bool last = i + 1 == segments.size();
    file.push_back(kEscape);
    file.push_back(last ? kEndOfImage : static_cast<std::byte>(kFirstRestart + i % 8));
  }
  return file;
}

void set_height(std::span<std::byte> file, int height) {
  const std::size_t frame = find_marker(file, kBaselineFrame);
  file[frame + 5] = static_cast<std::byte>(height >> 8);
  file[frame + 6] = static_cast<std::byte>(height & 255);
}

}  // namespace amalgam::codec
