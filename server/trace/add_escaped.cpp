// Verb: rays that meet nothing, or are cut off, take the environment.
#include "trace/tile.h"

namespace amalgam::trace {

void Tile::add_escaped() {
  for (const EscapedItem& item : escaped_) {
    SampleResult& sample = paths_.samples[item.sample];
    add_provenance(item.sample, item.source, mean_channel(item.weight));
    if (request_.environment == nullptr) continue;
    const glm::vec3 light =
        item.weight * scene::sample_environment(*request_.environment, item.direction);
    if (request_.environment->low_dynamic_range) {
      sample.environment_reflection += light;
    } else {
      sample.mixed += light;
      sample.real += light;
    }
  }
}

}  // namespace amalgam::trace
