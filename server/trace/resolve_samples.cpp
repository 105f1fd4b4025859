// The tile's finished samples become its pixels' share of the layers.
#include <cmath>

#include "scene/tone_map.h"
#include "trace/tile.h"

namespace amalgam::trace {
namespace {

std::uint64_t replace_nonfinite(glm::vec3& value) {
  if (std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z)) return 0;
  value = glm::vec3(0.0f);
  return 1;
}

}  // namespace

// Eq. 4.5 per sample, each with weight 1/n^2 (core/layers.h).
void Tile::resolve(TraceResult& result) {
  const int n = request_.samples_per_side;
  const float share = 1.0f / static_cast<float>(n * n);
  if (samples_.empty()) return;
  core::LayerTile& layers = result.layers.make(tile_);
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    SampleResult& sample = samples_[s];
    const SamplePlace& place = places_[s];
    const std::size_t pixel = core::LayerTile::index(place.pixel_x, place.pixel_y);
    counts_.nonfinite += replace_nonfinite(sample.mixed) + replace_nonfinite(sample.real) +
                         replace_nonfinite(sample.environment_reflection);
    const glm::vec3 mixed = scene::tone_map(sample.mixed, request_.exposure);
    if (sample.met_virtual) {
      layers.over[pixel] += share * glm::vec4(mixed + sample.environment_reflection, 1.0f);
    } else {
      layers.difference[pixel] += share * (mixed - scene::tone_map(sample.real, request_.exposure));
    }
    for (std::size_t k = 0; result.provenance && k < core::kLightSources; ++k) {
      result.provenance->at(place.pixel_x, place.pixel_y)[k] += share * sample.provenance[k];
    }
    if (result.images && place.first_of_pixel) {
      result.images->mixed.at(place.pixel_x, place.pixel_y) = sample.mixed;
      result.images->real.at(place.pixel_x, place.pixel_y) =
          glm::vec4(sample.real, static_cast<float>(sees_real_diffuse_[s]));
      result.images->environment_reflection.at(place.pixel_x, place.pixel_y) =
          sample.environment_reflection;
      result.images->met_virtual.at(place.pixel_x, place.pixel_y) = sample.met_virtual ? 1 : 0;
    }
  }
}

}  // namespace amalgam::trace
