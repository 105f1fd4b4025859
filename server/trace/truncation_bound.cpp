#include "trace/truncation_bound.h"

#include <glm/common.hpp>

#include "scene/light/tone_map.h"

namespace amalgam::trace {

glm::vec3 truncation_bound(const SampleResult& sample, const Truncation& truncation,
                           const RadianceLimit& limit, float exposure) {
  if (!sample.met_virtual) return glm::vec3(1.0f);
  const glm::vec3 now = scene::tone_map(sample.mixed, exposure);
  const glm::vec3 without = glm::max(sample.mixed - truncation.radiance, glm::vec3(0.0f));
  const glm::vec3 least = scene::tone_map(without, exposure);
  const glm::vec3 most = scene::tone_map(without + truncation.weight * limit.radiance, exposure);
  const glm::vec3 darker = now - least + truncation.environment;
  const glm::vec3 brighter =
      most - now +
      glm::max(truncation.weight * limit.environment - truncation.environment, glm::vec3(0.0f));
  return glm::max(darker, brighter);
}

}  // namespace amalgam::trace
