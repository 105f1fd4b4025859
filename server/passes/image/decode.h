// Decodes the camera image, on demand: look-ups, the exposure meter and the composite need its
// pixels.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "codec/jpeg_patch.h"
#include "common/camera_model.h"
#include "common/image.h"
#include "graph/frame_graph.h"

namespace amalgam::passes {

using EncodedOrPixels = std::variant<std::vector<std::byte>, common::ImageRgb8>;

// sRGB-encoded pixels of the camera's size.
struct CameraImage {
  common::ImageRgb8 pixels;
};

// The camera's JPEG ready to be patched (codec/jpeg_patch.h).
using CameraCoefficients = codec::JpegCoefficients;

struct DecodeInputs {
  const EncodedOrPixels& image;  // borrowed
  const common::CameraModel& camera;
  bool keep_coefficients = false;  // to make the composite a patch of the camera's JPEG
};

struct DecodeOutputs {
  graph::Handle<CameraImage> camera_image;
  // Absent if not requested, or if the image is no JPEG or one that cannot be patched.
  graph::Handle<CameraCoefficients> coefficients;
};

// Throws codec::JpegError if the bytes cannot be decoded or do not have the camera's size.
DecodeOutputs add_decode_pass(graph::FrameGraph& graph, const DecodeInputs& in);

}  // namespace amalgam::passes
