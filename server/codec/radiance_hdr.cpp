#include "codec/radiance_hdr.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "codec/radiance_header.h"

namespace amalgam::codec {
namespace {

using Rgbe = glm::u8vec4;

[[noreturn]] void fail(const char* why) {
  throw PictureError(std::string("damaged picture: ") + why);
}

class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::uint8_t byte() {
    if (bytes_.empty()) fail("truncated");
    const auto value = std::to_integer<std::uint8_t>(bytes_.front());
    bytes_ = bytes_.subspan(1);
    return value;
  }
  Rgbe pixel() {
    Rgbe pixel;
    for (int i = 0; i < 4; ++i) pixel[i] = byte();
    return pixel;
  }
  // The next pixel, left where it is; zeros at the end.
  Rgbe peek() const { return bytes_.size() < 4 ? Rgbe(0) : ByteReader(bytes_).pixel(); }

 private:
  std::span<const std::byte> bytes_;
};

// Each component by itself: n > 128 repeats a byte n - 128 times, another n counts bytes.
void read_component_runs(ByteReader& reader, std::span<Rgbe> line) {
  for (int component = 0; component < 4; ++component) {
    for (std::size_t i = 0; i < line.size();) {
      const std::uint8_t code = reader.byte();
      const bool is_run = code > 128;
      const std::size_t count = is_run ? code - 128u : code;
      if (count > line.size() - i) fail("a run is longer than its line");
      const std::uint8_t value = is_run ? reader.byte() : std::uint8_t{0};
      for (std::size_t k = 0; k < count; ++k) line[i++][component] = is_run ? value : reader.byte();
    }
  }
}

// Whole pixels, in which 1 1 1 n repeats the last one n times. Such ones in a row are the digits
// of one number in base 256, the lowest first.
void read_pixel_runs(ByteReader& reader, std::span<Rgbe> line) {
  int shift = 0;
  for (std::size_t i = 0; i < line.size();) {
    const Rgbe pixel = reader.pixel();
    if (pixel.x != 1 || pixel.y != 1 || pixel.z != 1) {
      line[i++] = pixel;
      shift = 0;
      continue;
    }
    if (i == 0) fail("a line begins with a run");
    const std::size_t count = shift < 24 ? std::size_t{pixel.w} << shift : 0;
    if (count > line.size() - i) fail("a run is longer than its line");
    std::fill_n(line.begin() + static_cast<std::ptrdiff_t>(i), count, line[i - 1]);
    i += count;
    shift += 8;
  }
}

void read_line(ByteReader& reader, std::span<Rgbe> line) {
  constexpr std::size_t kMinLength = 8, kMaxLength = 0x7FFF;
  const Rgbe mark = reader.peek();
  const bool by_component = line.size() >= kMinLength && line.size() <= kMaxLength && mark.x == 2 &&
                            mark.y == 2 && mark.z < 128;
  if (!by_component) return read_pixel_runs(reader, line);
  if (mark.z * 256u + mark.w != line.size()) fail("a line has another length than the size says");
  reader.pixel();
  read_component_runs(reader, line);
}

glm::vec3 color_of(const Rgbe& pixel, const glm::dvec3& scale) {
  constexpr int kBias = 128 + 8;  // of the exponent, and the mantissa's bits
  if (pixel.w == 0) return glm::vec3(0.0f);
  return glm::vec3(glm::dvec3(pixel.x, pixel.y, pixel.z) * std::ldexp(1.0, pixel.w - kBias) *
                   scale);
}

}  // namespace

common::ImageRgb32f decode_radiance_hdr(std::span<const std::byte> encoded) {
  const RadianceHeader header =
      read_radiance_header({reinterpret_cast<const char*>(encoded.data()), encoded.size()});
  check_picture_size(header.size);
  const glm::ivec2 size = header.size;
  common::ImageRgb32f image(size.x, size.y);
  ByteReader reader(encoded.subspan(header.pixels_at));
  const int lines = header.by_columns ? size.x : size.y;
  std::vector<Rgbe> line(static_cast<std::size_t>(header.by_columns ? size.y : size.x));
  const glm::dvec3 scale = 1.0 / header.exposure;
  for (int i = 0; i < lines; ++i) {
    read_line(reader, line);
    for (int k = 0; k < static_cast<int>(line.size()); ++k) {
      const int x = header.by_columns ? i : k, y = header.by_columns ? k : i;
      image.at(header.right_to_left ? size.x - 1 - x : x, header.bottom_up ? size.y - 1 - y : y) =
          color_of(line[static_cast<std::size_t>(k)], scale);
    }
  }
  if (header.is_xyz) {
    transform_colors(image, rec709_from_xyz());
  } else if (header.primaries) {
    const auto matrix = rec709_from(*header.primaries);
    if (!matrix) fail("its PRIMARIES span no color space");
    transform_colors(image, *matrix);
  }
  return image;
}

}  // namespace amalgam::codec
