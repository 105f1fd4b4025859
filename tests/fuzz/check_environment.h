// Reads bytes as an environment map: refused with SceneError, or radiance as environment.h promises
// it.
#pragma once

#include <glm/common.hpp>

#include "common/log.h"
#include "fuzz/scratch_file.h"
#include "scene/gltf/environment_loader.h"
#include "scene/gltf/sanitize.h"
#include "scene/scene_error.h"

namespace amalgam::fuzz {

inline void check_environment(const ScratchFile& file, std::string_view content) {
  std::vector<std::string> notes;
  try {
    const scene::Environment map = scene::load_environment(file.write(content), notes);
    AMALGAM_CHECK(!map.radiance.empty(), "an empty map");
    for (const glm::vec3& radiance : map.radiance.pixels()) {
      for (int i = 0; i < 3; ++i) {
        AMALGAM_CHECK(radiance[i] >= 0.0f && radiance[i] <= scene::kMaxRadiance,
                      std::to_string(radiance[i]));
      }
    }
  } catch (const scene::SceneError&) {
  }
}

}  // namespace amalgam::fuzz
