#include "passes/image/look_up.h"

namespace amalgam::passes {

graph::Handle<trace::TraceResult> add_look_up_pass(graph::FrameGraph& graph,
                                                   const LookUpInputs& in) {
  graph::Builder builder = graph.add_pass("look up");
  builder.needs(in.paths);
  builder.needs(in.camera_image);
  builder.needs(in.tone_map);
  const auto out = builder.writes<trace::TraceResult>("traced layers");
  builder.runs([in, out](const graph::Access& access) {
    access.set(out, trace::look_up_again(*access.get(in.paths), access.get(in.camera_image).pixels,
                                         access.get(in.tone_map), in.real_surfaces));
  });
  return out;
}

}  // namespace amalgam::passes
