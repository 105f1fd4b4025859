// Verb: the light of diffuse surfaces goes to their samples.
#include <glm/common.hpp>

#include "trace/tile.h"

namespace amalgam::trace {
namespace {

// Differential rendering along the ray: the camera's own colour L where it can be had, changed by
// what virtual objects change. L + (m - r) in that order, so that m = r leaves L exactly.
DiffuseRadiance with_camera_color(const CameraSample& seen, const DiffuseRadiance& modelled) {
  const glm::vec3 changed =
      glm::max(seen.radiance + (modelled.mixed - modelled.real), glm::vec3(0.0f));
  return {glm::mix(modelled.mixed, changed, seen.trust),
          glm::mix(modelled.real, seen.radiance, seen.trust)};
}

}  // namespace

void Tile::add_diffuse() {
  for (std::size_t d = 0; d < diffuse_.size(); ++d) {
    const DiffuseItem& item = diffuse_[d];
    SampleResult& sample = samples_[item.sample];
    const float share = mean_channel(item.weight);
    if (item.point.role == scene::Role::Virtual) {
      sample.mixed += item.weight * radiance_[d].mixed;
      add_share(sample.provenance, core::LightSource::TracedVirtual, share);
      continue;
    }
    const DiffuseRadiance radiance =
        item.seen ? with_camera_color(*item.seen, radiance_[d]) : radiance_[d];
    sample.mixed += item.weight * radiance.mixed;
    sample.real += item.weight * radiance.real;
    const float under_pixel = item.real_color == RealColor::UnderPixel ? 1.0f : 0.0f;
    const float from_camera = item.seen ? item.seen->trust : under_pixel;
    add_share(sample.provenance, core::LightSource::CameraLookup, share * from_camera);
    add_share(sample.provenance, core::LightSource::ModelledReal, share * (1.0f - from_camera));
  }
}

}  // namespace amalgam::trace
