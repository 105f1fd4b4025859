// Extracts lights from the environment, once for each environment (section 5.3).
#pragma once

#include <optional>
#include <vector>

#include "graph/frame_graph.h"
#include "scene/light/env_lights.h"
#include "scene/light/environment.h"
#include "scene/light/light.h"

namespace amalgam::passes {

using EnvironmentLights = std::vector<scene::Light>;  // world frame

// The current environment's lights; empty until they have been extracted. Owned by the caller, who
// resets it when the environment changes.
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
