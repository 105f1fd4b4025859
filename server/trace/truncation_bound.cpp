#include "trace/truncation_bound.h"

#include <glm/common.hpp>

namespace amalgam::trace {
glm::vec3 truncation_bound(const SampleResult& sample, const Truncation& truncation,
                           const RadianceLimit& limit, const scene::ToneMap& tone_map) {
  if (!sample.met_virtual) return glm::vec3(1.0f);
  // In this order NaN becomes 0, as it will in the picture.
  const glm::vec3 now =
      glm::min(glm::max(glm::vec3(0.0f), sample.mixed), glm::vec3(kNoRadianceLimit));
  const glm::vec3 least = glm::max(now - truncation.radiance, glm::vec3(0.0f));
  const glm::vec3 most = glm::max(least + truncation.weight * limit.radiance, now);
  const glm::vec3 darker = scene::tone_map_step(least, now, tone_map) + truncation.environment;
  const glm::vec3 brighter =
      scene::tone_map_step(now, most, tone_map) +
      glm::max(truncation.weight * limit.environment - truncation.environment, glm::vec3(0.0f));
  return glm::max(darker, brighter);
}

}  // namespace amalgam::trace
