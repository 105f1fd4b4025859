#include "trace/tracer.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <vector>

#include "core/pose.h"
#include "scene/tone_map.h"
#include "trace/media_at.h"
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
  core::LayerTile& layers = result.layers.make(result.layers.grid().tile_of(x_, y_));
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
          glm::vec4(sample.real, sees_real_diffuse_[s] ? 1.0f : 0.0f);
      result.images->environment_reflection.at(place.pixel_x, place.pixel_y) =
          sample.environment_reflection;
      result.images->met_virtual.at(place.pixel_x, place.pixel_y) = sample.met_virtual ? 1 : 0;
    }
  }
}

TraceResult trace(const TraceRequest& request) {
  const int width = request.camera.width, height = request.camera.height;
  TraceResult result;
  result.layers = core::Layers({width, height});
  if (request.keep_images) {
    result.images =
        TracedImages{core::ImageRgb32f(width, height), core::ImageRgba32f(width, height),
                     core::ImageRgb32f(width, height), core::Image<std::uint8_t>(width, height)};
  }
  if (request.keep_provenance) result.provenance.emplace(width, height);
  std::optional<CameraLookup> lookup;
  if (request.lookup != nullptr) lookup.emplace(*request.lookup);
  const Media camera_media =
      media_at(request.scene, glm::vec3(core::rigid_inverse(request.camera_from_world)[3]));

  const core::TileGrid& grid = result.layers.grid();
  std::vector<TileCounts> counts(grid.count());
  tbb::parallel_for(std::size_t{0}, counts.size(), [&](std::size_t index) {
    const glm::ivec2 first = grid.first_pixel(index);
    Tile tile(request, lookup ? &*lookup : nullptr, camera_media, first.x, first.y);
    tile.trace();
    tile.resolve(result);
    counts[index] = tile.counts();
  });
  for (const TileCounts& tile : counts) {
    result.rays += tile.rays;
    result.nonfinite += tile.nonfinite;
    result.traced_samples += tile.samples;
    result.primary_virtual += tile.primary_virtual;
    result.primary_specular += tile.primary_specular;
  }
  return result;
}

}  // namespace amalgam::trace
