// The camera image as pixels, decoded only for who needs them: look-ups, the exposure meter, the
// composite.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "core/camera_model.h"
#include "core/image.h"
#include "graph/frame_graph.h"

namespace amalgam::passes {

using EncodedOrPixels = std::variant<std::vector<std::byte>, core::ImageRgb8>;

// sRGB-encoded pixels of the camera's size.
struct CameraImage {
  core::ImageRgb8 pixels;
};

// Throws codec::JpegError if the bytes cannot be decoded or do not have the camera's size. Borrows
// image.
graph::Handle<CameraImage> add_decode_pass(graph::FrameGraph& graph, const EncodedOrPixels& image,
                                           const core::CameraModel& camera);

}  // namespace amalgam::passes
