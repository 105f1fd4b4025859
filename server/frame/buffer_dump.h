// The buffers of one frame, for comparison with the thesis.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "common/image.h"

namespace amalgam::graph {
class FrameGraph;
}
namespace amalgam::passes {
struct RenderView;
}

namespace amalgam::frame {

struct FramePasses;

// Named channels, for a buffer that is neither grey nor a color.
using Channels = std::vector<std::pair<std::string, common::Image32f>>;
using BufferImage =
    std::variant<common::Image32f, common::ImageRgb32f, common::ImageRgba32f, Channels>;

// By name: mixed (I_m), real (I_r), environment_reflection (I_e), virtual_mask (M_v), tracing_mask
// (M_r), real_depth, provenance (one channel for each source, core/provenance.h), and the layers
// over (A with a), difference (D) and light_ratio (q). Ideal camera geometry. Without buffers
// that the frame did not make.
using FrameBuffers = std::map<std::string, BufferImage>;

// Gathers the buffers of a finished frame. Runs no further pass.
FrameBuffers collect_buffers(const graph::FrameGraph& graph, const FramePasses& frame,
                             const passes::RenderView& view);

// Writes NAME.exr for each; creates the folder. Throws std::runtime_error.
void write_buffers(const FrameBuffers& buffers, const std::filesystem::path& folder);

}  // namespace amalgam::frame
