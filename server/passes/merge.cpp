#include "passes/merge.h"

#include <algorithm>

namespace amalgam::passes {
namespace {

void add(Layers& sum, const Layers& part) {
  const auto over = part.over.pixels();
  std::transform(over.begin(), over.end(), sum.over.data(), sum.over.data(), std::plus<>());
  const auto difference = part.difference.pixels();
  std::transform(difference.begin(), difference.end(), sum.difference.data(), sum.difference.data(),
                 std::plus<>());
}

bool is_zero(const Layers& layers) {
  const auto over = layers.over.pixels();
  const auto difference = layers.difference.pixels();
  return std::all_of(over.begin(), over.end(),
                     [](const glm::vec4& v) { return v == glm::vec4(0.0f); }) &&
         std::all_of(difference.begin(), difference.end(),
                     [](const glm::vec3& v) { return v == glm::vec3(0.0f); });
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
    if (is_zero(sum)) {
      access.leave_empty(out, "nothing virtual has an effect on this frame");
    } else {
      access.set(out, std::move(sum));
    }
  });
  return out;
}

}  // namespace amalgam::passes
