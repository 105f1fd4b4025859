#include "trace/resolve_tile.h"

#include <cmath>

#include "scene/light/tone_map.h"

namespace amalgam::trace {
namespace {

glm::vec3 replace_nonfinite(const glm::vec3& value, std::uint64_t& replaced) {
  if (std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z)) return value;
  ++replaced;
  return glm::vec3(0.0f);
}

void keep_images(const SampleResult& sample, TracedImages& images) {
  const int x = sample.pixel_x, y = sample.pixel_y;
  images.mixed.at(x, y) = sample.mixed;
  images.real.at(x, y) = glm::vec4(sample.real, sample.sees_real_diffuse ? 1.0f : 0.0f);
  images.environment_reflection.at(x, y) = sample.environment_reflection;
  images.met_virtual.at(x, y) = sample.met_virtual ? 1 : 0;
}

}  // namespace

std::uint64_t resolve_tile(std::size_t tile, const TilePaths& paths, int samples_per_side,
                           float exposure, TraceResult& result) {
  if (paths.samples.empty()) return 0;
  const float share = 1.0f / static_cast<float>(samples_per_side * samples_per_side);
  std::uint64_t replaced = 0;
  core::LayerTile& layers = result.layers.make(tile);
  for (SampleResult sample : paths.samples) {
    sample.mixed = replace_nonfinite(sample.mixed, replaced);
    sample.real = replace_nonfinite(sample.real, replaced);
    sample.environment_reflection = replace_nonfinite(sample.environment_reflection, replaced);
    const std::size_t pixel = core::LayerTile::index(sample.pixel_x, sample.pixel_y);
    const glm::vec3 mixed = scene::tone_map(sample.mixed, exposure);
    if (sample.met_virtual) {
      layers.over[pixel] += share * glm::vec4(mixed + sample.environment_reflection, 1.0f);
    } else {
      layers.difference[pixel] += share * (mixed - scene::tone_map(sample.real, exposure));
    }
    if (result.images && sample.first_of_pixel) keep_images(sample, *result.images);
  }
  return replaced;
}

}  // namespace amalgam::trace
