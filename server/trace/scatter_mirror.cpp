// A mirror: one reflected child (eq. 4.7).
#include <algorithm>
#include <glm/geometric.hpp>

#include "trace/tile.h"

namespace amalgam::trace {

void Tile::scatter_mirror(const RayItem& item, const MetSurface& met, const glm::dvec3& normal) {
  const double cos_incident = std::clamp(-glm::dot(item.direction, normal), 0.0, 1.0);
  const glm::vec3 k_s =
      reflectance_conductor(glm::vec3(met.point.base_color), static_cast<float>(cos_incident));
  spawn(item, met, glm::normalize(reflect(item.direction, normal)), met.weight * k_s,
        RayKind::Reflection, item.media);
}

}  // namespace amalgam::trace
