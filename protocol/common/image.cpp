#include "common/image.h"

#include <stdexcept>
#include <string>

namespace amalgam::common {

std::size_t checked_pixel_count(int width, int height) {
  constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;
  if (width < 0 || height < 0 || std::int64_t{width} * height > kMaxPixels) {
    throw std::invalid_argument("image size " + std::to_string(width) + "x" +
                                std::to_string(height) + " is outside what can be held");
  }
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace amalgam::common
