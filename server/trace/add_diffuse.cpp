// Verb: the light of diffuse surfaces goes to their samples, or waits for the camera's color.
#include "trace/tile.h"

namespace amalgam::trace {

void Tile::add_diffuse() {
  for (std::size_t d = 0; d < diffuse_.size(); ++d) {
    const DiffuseItem& item = diffuse_[d];
    const DiffuseRadiance& radiance = radiance_[d];
    SampleResult& sample = paths_.samples[item.sample];
    if (item.point.role == scene::Role::Virtual) {
      sample.mixed += item.weight * radiance.mixed;
      add_provenance(item.sample, core::LightSource::TracedVirtual, item.share);
      continue;
    }
    if (item.seen) {
      paths_.look_ups.push_back({item.weight, item.sample, item.seen->pixel, item.seen->trust,
                                 radiance.mixed, radiance.real});
    } else {
      sample.mixed += item.weight * radiance.mixed;
      sample.real += item.weight * radiance.real;
    }
    const float under_pixel = item.real_color == RealColor::UnderPixel ? 1.0f : 0.0f;
    const float from_camera = item.seen ? item.seen->trust : under_pixel;
    add_provenance(item.sample, core::LightSource::CameraLookup, item.share * from_camera);
    add_provenance(item.sample, core::LightSource::ModelledReal, item.share * (1.0f - from_camera));
  }
}

}  // namespace amalgam::trace
