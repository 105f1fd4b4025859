#include "passes/read_back.h"

#include <vector>

#include "core/log.h"
#include "gl/texture.h"

namespace amalgam::passes {

core::ImageRgba32f read_rgba(DeviceImage image) {
  AMALGAM_CHECK(image->format() == gl::TextureFormat::Rgba32f, "read_rgba of another format");
  core::ImageRgba32f pixels(image->size().x, image->size().y);
  image->read(pixels.data(), pixels.pixels().size_bytes());
  return pixels;
}

core::ImageRgba32f read_rgba_downsampled(DeviceImage image, int step) {
  if (step <= 1) return read_rgba(image);
  // Row by row: a scaling blit would do it in one go, but for even steps the middle of a block lies
  // between texels, and which one is taken is the driver's choice.
  const glm::ivec2 blocks = image->size() / step;
  core::ImageRgba32f picked(blocks.x, blocks.y);
  std::vector<glm::vec4> row(static_cast<std::size_t>(image->size().x));
  for (int y = 0; y < blocks.y; ++y) {
    image->read_row(y * step + step / 2, row.data(), row.size() * sizeof(glm::vec4));
    for (int x = 0; x < blocks.x; ++x) {
      picked.at(x, y) = row[static_cast<std::size_t>(x * step + step / 2)];
    }
  }
  return picked;
}

}  // namespace amalgam::passes
