#include "parity/composite_error.h"

#include <algorithm>

#include "scene/light/tone_map.h"

namespace amalgam::parity {
namespace {

template <typename Image>
Image layer(const frame::FrameBuffers& buffers, const char* name, glm::ivec2 size) {
  const auto found = buffers.find(name);
  return found != buffers.end() ? std::get<Image>(found->second) : Image(size.x, size.y);
}

}  // namespace

Error composite_error(const common::ImageRgb8& image, const frame::FrameBuffers& a,
                      const frame::FrameBuffers& b) {
  const glm::ivec2 size = image.size();
  const auto over_a = layer<common::ImageRgba32f>(a, "over", size),
             over_b = layer<common::ImageRgba32f>(b, "over", size);
  const auto difference_a = layer<common::ImageRgb32f>(a, "difference", size),
             difference_b = layer<common::ImageRgb32f>(b, "difference", size);
  Error error;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const glm::vec4 over = over_a.at(x, y) - over_b.at(x, y);
      const glm::vec3 change =
          glm::abs(glm::vec3(over) - over.w * scene::srgb_decode(image.at(x, y)) +
                   difference_a.at(x, y) - difference_b.at(x, y));
      error.mean += double{change.x + change.y + change.z} / 3.0;
      error.worst = std::max(error.worst, double{std::max({change.x, change.y, change.z})});
    }
  }
  error.mean /= static_cast<double>(size.x) * size.y;
  return error;
}

}  // namespace amalgam::parity
