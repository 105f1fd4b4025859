// Verb: the camera's own colour of each real surface that it sees as well (section 4.4).
#include "trace/tile.h"

namespace amalgam::trace {

void Tile::look_up_real() {
  if (context_.lookup == nullptr) return;
  for (DiffuseItem& item : diffuse_) {
    if (item.real_color != RealColor::LookedUp || item.point.role != scene::Role::Real) continue;
    item.seen = context_.lookup->look_up(request_.scene, item.point, counts_.rays.lookup);
  }
}

}  // namespace amalgam::trace
