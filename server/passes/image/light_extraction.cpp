#include "passes/image/light_extraction.h"

namespace amalgam::passes {

graph::Handle<EnvironmentLights> add_light_extraction_pass(graph::FrameGraph& graph,
                                                           const LightExtractionInputs& in) {
  constexpr const char* kPass = "light extraction";
  constexpr const char* kResource = "environment lights";
  if (in.environment == nullptr) {
    constexpr const char* kReason = "no environment in the scene";
    graph.note_left_out(kPass, kReason);
    return graph.absent<EnvironmentLights>(kResource, kReason);
  }
  if (in.cache) {
    graph.note_left_out(kPass, "the environment has not changed");
    return graph.import(kResource, *in.cache);
  }
  graph::Builder builder = graph.add_pass(kPass);
  const auto out = builder.writes<EnvironmentLights>(kResource);
  builder.runs([in, out](const graph::Access& access) {
    in.cache = scene::extract_lights(*in.environment, in.options);
    access.set(out, *in.cache);
  });
  return out;
}

}  // namespace amalgam::passes
