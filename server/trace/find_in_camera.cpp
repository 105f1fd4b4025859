// Verb: finds the pixel at which the camera sees each real surface that a ray met (section 4.4).
// The color is looked up when all rays are done (add_look_ups.h).
#include "trace/tile.h"

namespace amalgam::trace {

void Tile::find_in_camera() {
  if (context_.lookup == nullptr) return;
  for (DiffuseItem& item : diffuse_) {
    if (item.real_color != RealColor::LookedUp || item.point.role != scene::Role::Real) continue;
    item.seen = context_.lookup->find(request_.scene, item.point, counts_.rays.lookup);
  }
}

}  // namespace amalgam::trace
