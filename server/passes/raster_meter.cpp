#include "passes/raster_meter.h"

#include "passes/read_back.h"

namespace amalgam::passes {

graph::Handle<MeterGrid> add_raster_meter_pass(graph::FrameGraph& graph, const RenderView& view,
                                               graph::Handle<DeviceImage> real) {
  graph::Builder builder = graph.add_pass("meter");
  builder.needs(real);
  const auto out = builder.writes<MeterGrid>("meter grid");
  builder.runs([real, out, &view](const graph::Access& access) {
    const int n = view.samples_per_side;
    const int step = meter_step(glm::ivec2(view.ideal.width, view.ideal.height) * n);
    access.set(out, MeterGrid{read_rgba_downsampled(access.get(real), step), step, n});
  });
  return out;
}

}  // namespace amalgam::passes
