#include "passes/image/decode.h"

#include <tbb/parallel_invoke.h>

#include <optional>
#include <string>
#include <utility>

#include "codec/jpeg.h"

namespace amalgam::passes {
namespace {

struct Decoded {
  common::ImageRgb8 pixels;
  std::optional<codec::JpegCoefficients> coefficients;
};

// Pixels and coefficients at the same time: each takes one core.
Decoded decode(const DecodeInputs& in) {
  if (const auto* pixels = std::get_if<common::ImageRgb8>(&in.image))
    return {*pixels, std::nullopt};
  const auto& jpeg = std::get<std::vector<std::byte>>(in.image);
  Decoded decoded;
  if (in.keep_coefficients) {
    tbb::parallel_invoke([&] { decoded.pixels = codec::decode_jpeg(jpeg); },
                         [&] { decoded.coefficients = codec::JpegCoefficients::read(jpeg); });
  } else {
    decoded.pixels = codec::decode_jpeg(jpeg);
  }
  return decoded;
}

}  // namespace

DecodeOutputs add_decode_pass(graph::FrameGraph& graph, const DecodeInputs& in) {
  graph::Builder builder = graph.add_pass("decode");
  const DecodeOutputs out{builder.writes<CameraImage>("camera image"),
                          builder.writes<CameraCoefficients>("camera coefficients")};
  builder.runs([out, in](const graph::Access& access) {
    Decoded decoded = decode(in);
    const common::ImageRgb8& pixels = decoded.pixels;
    if (pixels.width() != in.camera.width || pixels.height() != in.camera.height) {
      throw codec::JpegError("the camera image is " + std::to_string(pixels.width()) + "x" +
                             std::to_string(pixels.height()) + ", announced were " +
                             std::to_string(in.camera.width) + "x" +
                             std::to_string(in.camera.height));
    }
    access.set(out.camera_image, CameraImage{std::move(decoded.pixels)});
    if (decoded.coefficients) {
      access.set(out.coefficients, std::move(*decoded.coefficients));
    } else {
      access.leave_empty(out.coefficients, "the camera's JPEG is not patched");
    }
  });
  return out;
}

}  // namespace amalgam::passes
