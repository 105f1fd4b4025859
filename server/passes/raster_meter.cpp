#include "passes/raster_meter.h"

#include "passes/read_back.h"

namespace amalgam::passes {

graph::Handle<MeterGrid> add_raster_meter_pass(graph::FrameGraph& graph, const RenderView& view,
                                               graph::Handle<DeviceImage> real) {
  graph::Handle<MeterGrid> out;
  graph.add_pass(
      "meter",
      [&](graph::Builder& builder) {
        builder.needs(real);
        out = builder.writes<MeterGrid>("meter grid");
      },
      [real, out, &view](const graph::Access& access) {
        const int n = view.samples_per_side;
        const int step = meter_step(glm::ivec2(view.ideal.width, view.ideal.height) * n);
        access.set(out, MeterGrid{read_rgba_downsampled(access.get(real), step), step, n});
      });
  return out;
}

}  // namespace amalgam::passes
