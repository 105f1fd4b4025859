// Encodes the composite as JPEG, for the wire.
#pragma once

#include <cstddef>
#include <vector>

#include "graph/frame_graph.h"
#include "passes/image/composite.h"
#include "passes/image/decode.h"

namespace amalgam::passes {

struct EncodedImage {
  std::vector<std::byte> jpeg;
};

struct EncodeInputs {
  graph::Handle<Composite> composite;
  // May be absent. Otherwise the composite is a patch of the camera's JPEG: unchanged blocks keep
  // the camera's coefficients bit for bit, and the others take its quality.
  graph::Handle<CameraCoefficients> coefficients;
  int quality = 90;  // 1 to 100, if the whole composite is encoded
  // Borrowed; may be null. Its metadata (EXIF, color profile) go into the composite.
  const EncodedOrPixels* camera = nullptr;
};

graph::Handle<EncodedImage> add_encode_pass(graph::FrameGraph& graph, const EncodeInputs& in);

}  // namespace amalgam::passes
