#include "trace/resolve_tile.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/light/tone_map.h"
#include "trace/truncation_bound.h"

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

// Of a tile's pixels: the mean over the samples of each.
core::TruncationBound bound_truncation(const TilePaths& paths, const RadianceLimit& limit,
                                       float share, float exposure) {
  core::TruncationBound bound;
  if (paths.truncations.empty()) return bound;
  std::array<glm::vec3, core::LayerTile::kPixels> pixels{};
  for (std::size_t s = 0; s < paths.samples.size(); ++s) {
    const Truncation& truncation = paths.truncations[s];
    if (truncation.weight == glm::vec3(0.0f)) continue;
    const SampleResult& sample = paths.samples[s];
    pixels[core::LayerTile::index(sample.pixel_x, sample.pixel_y)] +=
        share * truncation_bound(sample, truncation, limit, exposure);
  }
  for (const glm::vec3& pixel : pixels) {
    bound += {.sum = double{pixel.x + pixel.y + pixel.z} / 3.0,
              .worst = std::max({pixel.x, pixel.y, pixel.z})};
  }
  return bound;
}

}  // namespace

ResolvedTile resolve_tile(std::size_t tile, const TilePaths& paths, const RadianceLimit& limit,
                          int samples_per_side, float exposure, TraceResult& result) {
  ResolvedTile resolved;
  if (paths.samples.empty()) return resolved;
  const float share = 1.0f / static_cast<float>(samples_per_side * samples_per_side);
  resolved.truncation = bound_truncation(paths, limit, share, exposure);
  std::uint64_t& replaced = resolved.nonfinite;
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
  return resolved;
}

}  // namespace amalgam::trace
