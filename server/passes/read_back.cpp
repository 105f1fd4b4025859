#include "passes/read_back.h"

#include "core/log.h"
#include "gl/texture.h"

namespace amalgam::passes {

core::ImageRgba32f read_rgba(DeviceImage image) {
  AMALGAM_CHECK(image->format() == gl::TextureFormat::Rgba32f, "read_rgba of another format");
  core::ImageRgba32f pixels(image->size().x, image->size().y);
  image->read(pixels.data(), pixels.pixels().size_bytes());
  return pixels;
}

}  // namespace amalgam::passes
