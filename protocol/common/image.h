// Owns a rectangle of pixels of any type.
//
// Row 0 is the top of the picture and column 0 its left, as in a camera image. A pixel's centre has
// integer coordinates (OpenCV's convention), so a picture covers [-0.5, width - 0.5] x [-0.5,
// height - 0.5].
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace amalgam::common {

using Rgb8 = glm::u8vec3;
using Rgba8 = glm::u8vec4;

// The number of pixels. Throws std::invalid_argument if a side is negative or the number exceeds
// 2^28.
std::size_t checked_pixel_count(int width, int height);

template <typename Pixel>
class Image {
 public:
  Image() = default;
  Image(int width, int height, const Pixel& fill = Pixel{})
      : width_(width), height_(height), pixels_(checked_pixel_count(width, height), fill) {}

  int width() const { return width_; }
  int height() const { return height_; }
  glm::ivec2 size() const { return {width_, height_}; }
  bool empty() const { return pixels_.empty(); }

  Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
  const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }

  std::span<Pixel> pixels() { return pixels_; }
  std::span<const Pixel> pixels() const { return pixels_; }
  Pixel* data() { return pixels_.data(); }
  const Pixel* data() const { return pixels_.data(); }

  bool operator==(const Image&) const = default;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<Pixel> pixels_;
};

using ImageRgb8 = Image<Rgb8>;
using ImageRgba8 = Image<Rgba8>;
using ImageRgb32f = Image<glm::vec3>;
using ImageRgba32f = Image<glm::vec4>;
using Image32f = Image<float>;

}  // namespace amalgam::common
