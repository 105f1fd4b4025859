// What a camera writes into its JPEG beside the picture, carried over to the composite: EXIF, XMP
// and the ICC profile. Without EXIF's orientation, or with another profile, a viewer would show
// composites unlike the untouched frames between them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace amalgam::codec {

// The segments, each with its marker. jpeg: has passed read_jpeg_header().
std::vector<std::byte> jpeg_metadata(std::span<const std::byte> jpeg);

// Puts them into a file that this library has written, after its JFIF header.
void insert_metadata(std::vector<std::byte>& jpeg, std::span<const std::byte> metadata);

}  // namespace amalgam::codec
