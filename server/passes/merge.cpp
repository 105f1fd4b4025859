#include "passes/merge.h"

#include <algorithm>

namespace amalgam::passes {
namespace {

void add(Layers& sum, const Layers& part) {
  for (const std::size_t tile : part.present()) {
    const core::LayerTile& from = *part.find(tile);
    core::LayerTile& to = sum.make(tile);
    std::transform(from.over.begin(), from.over.end(), to.over.begin(), to.over.begin(),
                   std::plus<>());
    std::transform(from.difference.begin(), from.difference.end(), to.difference.begin(),
                   to.difference.begin(), std::plus<>());
  }
}

}  // namespace

graph::Handle<Layers> add_merge_pass(graph::FrameGraph& graph, const MergeInputs& in) {
  graph::Builder builder = graph.add_pass("merge");
  builder.needs_any(in.rasterised);
  builder.needs_any(in.traced);
  const auto out = builder.writes<Layers>("layers");
  builder.runs([in, out](const graph::Access& access) {
    const Layers* rasterised = access.find(in.rasterised);
    const trace::TraceResult* traced = access.find(in.traced);
    Layers sum;
    if (rasterised != nullptr) sum = *rasterised;
    if (traced != nullptr) {
      if (rasterised != nullptr) {
        add(sum, traced->layers);
      } else {
        sum = traced->layers;
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
