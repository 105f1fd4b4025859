#include "trace/tile.h"

#include <algorithm>

namespace amalgam::trace {
namespace {

constexpr std::size_t kBatchSize = 64;  // so that the queues stay in the innermost caches

}  // namespace

Tile::Tile(const TileContext& context)
    : context_(context),
      request_(context.request),
      grid_({request_.camera.width, request_.camera.height}),
      sample_spread_(1.0 / (request_.camera.fy * request_.samples_per_side)) {}

void Tile::start(std::size_t tile) {
  tile_ = tile;
  paths_.samples.clear();
  paths_.look_ups.clear();
  paths_.truncations.clear();
  provenance_.clear();
  logged_.clear();
  counts_ = {};
}

void Tile::trace() {
  generate_primary_rays();
  while (!waiting_.empty()) {
    take_batch();
    intersect_rays();
    shade_hits();
    add_escaped();
    find_in_camera();
    spawn_shadow_rays();
    trace_shadow_rays();
    add_diffuse();
  }
}

void Tile::take_batch() {
  const std::size_t count = std::min(waiting_.size(), kBatchSize);
  batch_.assign(waiting_.rbegin(), waiting_.rbegin() + static_cast<std::ptrdiff_t>(count));
  waiting_.resize(waiting_.size() - count);
  hits_.clear();
  escaped_.clear();
  diffuse_.clear();
  shadows_.clear();
}

glm::vec3 Tile::light_weight(const glm::vec3& ray_weight, const Media& media) const {
  const auto& materials = request_.scene.scene().materials;
  const double ratio =
      refractive_index(context_.camera_media, materials) / refractive_index(media, materials);
  return static_cast<float>(ratio * ratio) * ray_weight;
}

void Tile::add_provenance(std::uint32_t sample, core::LightSource source, float share) {
  if (request_.keep_provenance) core::add_share(provenance_[sample], source, share);
}

void Tile::log(const Ray& ray, Visible visible, RayQuery query) {
  if (request_.ray_log != nullptr) logged_.push_back({ray, visible, query});
}

void Tile::keep_provenance(core::ProvenanceImage& image) const {
  const float share =
      1.0f / static_cast<float>(request_.samples_per_side * request_.samples_per_side);
  for (std::size_t s = 0; s < provenance_.size(); ++s) {
    const SampleResult& sample = paths_.samples[s];
    core::Provenance& pixel = image.at(sample.pixel_x, sample.pixel_y);
    for (std::size_t k = 0; k < core::kLightSources; ++k) pixel[k] += share * provenance_[s][k];
  }
}

}  // namespace amalgam::trace
