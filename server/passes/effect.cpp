#include "passes/effect.h"

#include "gl/framebuffer.h"
#include "gl/pipeline_state.h"
#include "gl/query.h"
#include "gl/shader_interface.h"
#include "passes/draw_items.h"

namespace amalgam::passes {
namespace {

bool anything_virtual_shows(const RasterContext& raster, DeviceImage mixed, DeviceImage real) {
  const gl::Framebuffer framebuffer({.size_of_none = mixed->size()});
  gl::apply({});
  framebuffer.bind();
  mixed->bind(gl::kMixedUnit);
  real->bind(gl::kRealUnit);
  const gl::AnySamplesQuery query;
  query.begin();
  cover_screen(raster, raster.shaders.query_effect);
  query.end();
  return query.wait();
}

}  // namespace

EffectOutputs add_effect_pass(graph::FrameGraph& graph, const EffectInputs& in) {
  graph::Builder builder = graph.add_pass("effect");
  builder.needs(in.diffuse.mixed);
  builder.needs(in.diffuse.real);
  const EffectOutputs out{.effect = builder.writes<DiffuseEffect>("diffuse effect")};
  builder.runs([in, out](const graph::Access& access) {
    if (anything_virtual_shows(in.raster, access.get(in.diffuse.mixed),
                               access.get(in.diffuse.real))) {
      access.set(out.effect, DiffuseEffect{});
    } else {
      access.leave_empty(out.effect, "nothing virtual has an effect on this frame");
    }
  });
  return out;
}

}  // namespace amalgam::passes
