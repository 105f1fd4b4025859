// Verb: rays that meet nothing, or are cut off, take the environment.
#include "trace/tile.h"

namespace amalgam::trace {

void Tile::add_escaped() {
  for (const EscapedItem& item : escaped_) {
    SampleResult& sample = paths_.samples[item.sample];
    add_provenance(item.sample, item.source, mean_channel(item.weight));
    const scene::Environment* environment = request_.environment;
    const bool is_ldr = environment != nullptr && environment->low_dynamic_range;
    const glm::vec3 weight = light_weight(item.weight, Media());  // the environment lies in air
    const glm::vec3 light = environment != nullptr
                                ? weight * scene::sample_environment(*environment, item.direction)
                                : glm::vec3(0.0f);
    if (is_ldr) {
      sample.environment_reflection += light;
    } else {
      sample.mixed += light;
      sample.real += light;
    }
    if (item.source != core::LightSource::CutOff) continue;
    paths_.truncations.resize(paths_.samples.size());
    Truncation& truncation = paths_.truncations[item.sample];
    truncation.weight += weight;
    (is_ldr ? truncation.environment : truncation.radiance) += light;
  }
}

}  // namespace amalgam::trace
