#include "passes/decode.h"

#include <string>

#include "codec/jpeg.h"

namespace amalgam::passes {
namespace {

core::ImageRgb8 decode(const EncodedOrPixels& image) {
  if (const auto* pixels = std::get_if<core::ImageRgb8>(&image)) return *pixels;
  return codec::decode_jpeg(std::get<std::vector<std::byte>>(image));
}

}  // namespace

graph::Handle<CameraImage> add_decode_pass(graph::FrameGraph& graph, const EncodedOrPixels& image,
                                           const core::CameraModel& camera) {
  graph::Builder builder = graph.add_pass("decode");
  const auto out = builder.writes<CameraImage>("camera image");
  builder.runs([out, &image, &camera](const graph::Access& access) {
    core::ImageRgb8 pixels = decode(image);
    if (pixels.width() != camera.width || pixels.height() != camera.height) {
      throw codec::JpegError("the camera image is " + std::to_string(pixels.width()) + "x" +
                             std::to_string(pixels.height()) + ", announced were " +
                             std::to_string(camera.width) + "x" + std::to_string(camera.height));
    }
    access.set(out, CameraImage{std::move(pixels)});
  });
  return out;
}

}  // namespace amalgam::passes
