#include "passes/image/merge.h"

#include <utility>

namespace amalgam::passes {

graph::Handle<Layers> add_merge_pass(graph::FrameGraph& graph, const MergeInputs& in) {
  graph::Builder builder = graph.add_pass("merge");
  builder.needs_any(in.rasterised);
  builder.needs_any(in.traced);
  const auto out = builder.writes<Layers>("layers");
  builder.runs([in, out](const graph::Access& access) {
    // Taken, not copied: no other pass reads these layers.
    const bool rasterised = access.find(in.rasterised) != nullptr;
    Layers sum = rasterised ? access.take(in.rasterised) : Layers();
    if (access.find(in.traced) != nullptr) {
      Layers traced = access.take(in.traced, &trace::TraceResult::layers);
      if (rasterised) {
        sum.add(std::move(traced));
      } else {
        sum = std::move(traced);
      }
    }
    if (sum.is_zero()) {
      access.leave_empty(out, "nothing virtual has an effect on this frame");
    } else {
      access.set(out, std::move(sum));
    }
  });
  return out;
}

}  // namespace amalgam::passes
