// The composite as JPEG, for the wire.
#pragma once

#include <cstddef>
#include <vector>

#include "graph/frame_graph.h"
#include "passes/composite.h"

namespace amalgam::passes {

struct EncodedImage {
  std::vector<std::byte> jpeg;
};

// quality: 1 to 100.
graph::Handle<EncodedImage> add_encode_pass(graph::FrameGraph& graph,
                                            graph::Handle<Composite> composite, int quality);

}  // namespace amalgam::passes
