#include "passes/read_back.h"

#include "core/log.h"
#include "gl/framebuffer.h"
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
  // A nearest-neighbour blit takes the source texel at the centre of each block.
  const glm::ivec2 blocks = image->size() / step;
  if (blocks.x == 0 || blocks.y == 0) return {};
  const gl::Texture small(gl::TextureFormat::Rgba32f, blocks);
  const gl::Framebuffer from({.colors = {image}}), to({.colors = {&small}});
  const glm::ivec2 covered = blocks * step;
  glBlitNamedFramebuffer(from.id(), to.id(), 0, 0, covered.x, covered.y, 0, 0, blocks.x, blocks.y,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
  return read_rgba(&small);
}

}  // namespace amalgam::passes
