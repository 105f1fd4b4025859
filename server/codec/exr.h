// High-dynamic-range images as OpenEXR files: environment maps in, dumps and goldens out. The only
// user of OpenEXR.
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/image.h"

namespace amalgam::codec {

// What was wrong with a file, in one line that names it.
class ExrError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

constexpr int kMaxExrSide = 16384;                             // pixels
constexpr std::int64_t kMaxExrPixels = std::int64_t{1} << 26;  // 64 Mpixel
constexpr std::uintmax_t kMaxExrBytes = std::uintmax_t{512} << 20;

// A file's channels, by name, as floats. Reads half and float pixels, scan lines or tiles (level 0
// of a mip-mapped file), and the first of several parts. The image covers the data window, whose
// top left pixel becomes (0, 0). Values are unchanged, NaN, infinity and negative ones included.
// Throws ExrError if the file is missing, damaged, deep, sub-sampled or larger than the limits.
std::map<std::string, common::Image32f> read_exr_channels(const std::filesystem::path& path);

// The colors of a file, as scene-linear Rec. 709 on an equirectangular map if it says that it is a
// map.
//
// Channels: R, G and B (a missing one is 0), or those of the only layer that has all three, or of
// the layer "Combined" (Blender), or Y in all three. The first part that has one of these is read,
// and of it only these channels. Chromaticities are converted; cube maps are laid out anew. Says in
// notes which of this it did. Throws ExrError as read_exr_channels() does, and naming the layers if
// there is a choice.
common::ImageRgb32f read_exr(const std::filesystem::path& path,
                             std::vector<std::string>* notes = nullptr);

// As 32-bit floats, ZIP-compressed. All channels must have one size. comments: the attribute of
// that name, if not empty. Throws ExrError.
void write_exr(const std::filesystem::path& path,
               const std::vector<std::pair<std::string, common::Image32f>>& channels,
               const std::string& comments = {});
void write_exr(const std::filesystem::path& path, const common::ImageRgb32f& image,
               const std::string& comments = {});  // R G B
void write_exr(const std::filesystem::path& path, const common::ImageRgba32f& image,
               const std::string& comments = {});  // R G B A
void write_exr(const std::filesystem::path& path, const common::Image32f& image,
               const std::string& comments = {});  // Y

}  // namespace amalgam::codec
