#include "passes/raster/real_depth.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "gl/framebuffer.h"
#include "gl/pipeline_state.h"
#include "passes/raster/draw_items.h"

namespace amalgam::passes {
namespace {

bool is_real(const DrawItem& item) {
  return item.role == scene::Role::Real;
}

RealDepth draw_real_depth(const RealDepthInputs& in, const DeviceView& device_view) {
  const glm::ivec2 size(in.view.ideal.width, in.view.ideal.height);
  const gl::Texture& depth =
      ensure_target(in.raster.targets.real_depth, gl::TextureFormat::Depth32f, size);
  const gl::Framebuffer framebuffer({.depth = &depth});
  gl::apply({.depth = gl::PipelineState::Depth::NearestWrites});
  framebuffer.bind();
  framebuffer.clear_depth();
  draw_items(in.raster, device_view, in.raster.shaders.draw_depth, TextureUse::Holes, is_real);

  RealDepth result{common::Image32f(size.x, size.y)};
  depth.read(result.z.data(), result.z.pixels().size_bytes());
  // Reversed depth with an infinite far side is near / z, and 0 where nothing was drawn.
  // A division by 0 gives infinity, as wanted, and no branch.
  tbb::parallel_for(0, size.y, [&](int y) {
    float* row = &result.z.at(0, y);
    for (int x = 0; x < size.x; ++x) row[x] = static_cast<float>(kNearPlane) / row[x];
  });
  return result;
}

}  // namespace

RealDepthOutputs add_real_depth_pass(graph::FrameGraph& graph, const RealDepthInputs& in) {
  graph::Builder builder = graph.add_pass("real depth");
  builder.needs(in.specular);
  builder.needs(in.device_view);
  const RealDepthOutputs out{.depth = builder.writes<RealDepth>("real-only depth")};
  builder.runs([in, out](const graph::Access& access) {
    const DeviceView& device_view = access.get(in.device_view);
    if (std::any_of(device_view.items.begin(), device_view.items.end(), is_real)) {
      access.set(out.depth, draw_real_depth(in, device_view));
    } else {
      access.leave_empty(out.depth, "no real object in view");
    }
  });
  return out;
}

}  // namespace amalgam::passes
