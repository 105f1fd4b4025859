#include "trace/resolve_tile.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/light/real_surfaces.h"
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
                                       float share, const scene::ToneMap& tone_map) {
  core::TruncationBound bound;
  if (paths.truncations.empty()) return bound;
  std::array<glm::vec3, core::LayerTile::kPixels> pixels{};
  for (std::size_t s = 0; s < paths.samples.size(); ++s) {
    const Truncation& truncation = paths.truncations[s];
    if (truncation.weight == glm::vec3(0.0f)) continue;
    const SampleResult& sample = paths.samples[s];
    pixels[core::LayerTile::index(sample.pixel_x, sample.pixel_y)] +=
        share * truncation_bound(sample, truncation, limit, tone_map);
  }
  for (const glm::vec3& pixel : pixels) {
    bound += {.sum = double{pixel.x + pixel.y + pixel.z} / 3.0,
              .worst = std::max({pixel.x, pixel.y, pixel.z})};
  }
  return bound;
}

core::LayerPixel resolve_sample(const SampleResult& sample, const scene::ToneMap& tone_map,
                                scene::RealSurfaces real_surfaces) {
  if (sample.met_virtual) {
    const glm::vec3 mixed = scene::tone_map(sample.mixed, tone_map);
    return {.over = glm::vec4(mixed + sample.environment_reflection, 1.0f)};
  }
  // A real mirror's image has no light of its own to be scaled: only diffuse surfaces do.
  const scene::LightChange change = scene::light_change(
      sample.mixed, sample.real, tone_map,
      sample.sees_real_diffuse ? real_surfaces : scene::RealSurfaces::Difference);
  return {.difference = change.difference, .relative_change = change.relative};
}

}  // namespace

ResolvedTile resolve_tile(std::size_t tile, const TilePaths& paths, const RadianceLimit& limit,
                          int samples_per_side, const scene::ToneMap& tone_map,
                          scene::RealSurfaces real_surfaces, TraceResult& result) {
  ResolvedTile resolved;
  if (paths.samples.empty()) return resolved;
  const float share = 1.0f / static_cast<float>(samples_per_side * samples_per_side);
  resolved.truncation = bound_truncation(paths, limit, share, tone_map);
  std::uint64_t& replaced = resolved.nonfinite;
  core::LayerTile& layers = result.layers.make(tile);
  for (SampleResult sample : paths.samples) {
    sample.mixed = replace_nonfinite(sample.mixed, replaced);
    sample.real = replace_nonfinite(sample.real, replaced);
    sample.environment_reflection = replace_nonfinite(sample.environment_reflection, replaced);
    core::LayerPixel layer = resolve_sample(sample, tone_map, real_surfaces);
    layer *= share;
    layers.at(sample.pixel_x, sample.pixel_y) += layer;
    if (result.images && sample.first_of_pixel) keep_images(sample, *result.images);
  }
  return resolved;
}

}  // namespace amalgam::trace
