// JPEGs that claim what is not true: made of good ones, by changing their headers.
#pragma once

#include <cstddef>
#include <vector>

namespace amalgam::test_support {

using JpegBytes = std::vector<std::byte>;

// Where the marker code of the baseline frame header stands (the byte after 0xFF). Throws
// std::invalid_argument if there is none.
std::size_t frame_marker(const JpegBytes& jpeg);
// Of another size by its header.
JpegBytes with_size(JpegBytes jpeg, int width, int height);
// With so many empty scans more at its end, and without an end marker.
JpegBytes with_more_scans(JpegBytes jpeg, int more);

}  // namespace amalgam::test_support
