// Verb: finds the nearest hit of each ray of the batch.
#include <glm/geometric.hpp>

#include "trace/refine_hit.h"
#include "trace/tile.h"

namespace amalgam::trace {
namespace {

std::uint64_t& count_of(core::RayCounts& counts, RayKind kind) {
  switch (kind) {
    case RayKind::Primary:
      return counts.primary;
    case RayKind::Reflection:
      return counts.reflection;
    case RayKind::Refraction:
      break;
  }
  return counts.refraction;
}

}  // namespace

void Tile::intersect_rays() {
  for (const RayItem& item : batch_) {
    ++count_of(counts_.rays, item.kind);
    log(item.ray, Visible::Everything, RayQuery::Nearest);
    hits_.push_back(request_.scene.intersect(item.ray, Visible::Everything));
    if (hits_.back()) request_.scene.triangle(*hits_.back()).prefetch();
  }
  for (std::size_t i = 0; i < batch_.size(); ++i) {
    const RayItem& item = batch_[i];
    std::optional<Hit>& hit = hits_[i];
    if (!hit) continue;
    hit->t += glm::distance(item.start, glm::dvec3(item.ray.origin));
    hit = refine_hit(request_.scene, *hit, item.start, item.direction, Visible::Everything);
  }
}

}  // namespace amalgam::trace
