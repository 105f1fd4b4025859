// The environment as lights: extracted once for each environment (section 5.3).
#pragma once

#include <optional>
#include <vector>

#include "graph/frame_graph.h"
#include "scene/light/env_lights.h"
#include "scene/light/environment.h"
#include "scene/light/light.h"

namespace amalgam::passes {

using EnvironmentLights = std::vector<scene::Light>;  // world frame

// The lights of the environment there is; none until they have been extracted. Owned by the caller,
// who empties it when the environment changes.
using EnvironmentLightCache = std::optional<EnvironmentLights>;

struct LightExtractionInputs {
  const scene::Environment* environment = nullptr;  // null: the scene has none
  const scene::EnvLightOptions& options;
  EnvironmentLightCache& cache;
};

// Absent: "no environment in the scene".
graph::Handle<EnvironmentLights> add_light_extraction_pass(graph::FrameGraph& graph,
                                                           const LightExtractionInputs& in);

}  // namespace amalgam::passes
