#include "passes/raster/read_back.h"

#include "common/log.h"
#include "gl/texture.h"

namespace amalgam::passes {

common::ImageRgba32f read_rgba(DeviceImage image) {
  AMALGAM_CHECK(image->format() == gl::TextureFormat::Rgba32f, "read_rgba of another format");
  common::ImageRgba32f pixels(image->size().x, image->size().y);
  image->read(pixels.data(), pixels.pixels().size_bytes());
  return pixels;
}

}  // namespace amalgam::passes
