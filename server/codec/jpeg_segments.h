// Cuts a JPEG at its restart markers, and joins segments of several files to one.
//
// The Huffman code between two restart markers does not depend on anything before it. So segments
// of files with the same tables can be mixed.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace amalgam::codec {

using JpegSegment = std::span<const std::byte>;

class SegmentedJpeg {
 public:
  // file: of one scan, written by this library.
  explicit SegmentedJpeg(std::vector<std::byte> file);

  // Everything up to the end of the scan's header.
  std::span<const std::byte> head() const { return std::span(file_).first(begins_.front()); }
  std::size_t count() const { return begins_.size() - 1; }
  JpegSegment segment(std::size_t index) const;

 private:
  std::vector<std::byte> file_;
  std::vector<std::size_t> begins_;  // of the segments, and one past the last
};

// A file of the head and the segments, with restart markers between them and an end marker.
std::vector<std::byte> join_segments(std::span<const std::byte> head,
                                     std::span<const JpegSegment> segments);

// Changes the height that a baseline file's frame header announces.
void set_height(std::span<std::byte> file, int height);

}  // namespace amalgam::codec
