// A thin sheet of glass: both its surfaces at once, and the ray goes straight on.
#include <algorithm>
#include <glm/geometric.hpp>

#include "trace/tile.h"

namespace amalgam::trace {

void Tile::scatter_thin(const RayItem& item, const MetSurface& met, const glm::dvec3& normal) {
  const SurfacePoint& point = met.point;
  const double cos_incident = std::clamp(-glm::dot(item.direction, normal), 0.0, 1.0);
  const double ior = material(point.material).ior;
  const auto k_s = static_cast<float>(
      thin_sheet_reflectance(reflectance(request_.settings.fresnel, cos_incident, 1.0, ior)));
  const glm::vec3 tint = point.transmission * glm::vec3(point.base_color);
  spawn(item, met, glm::normalize(reflect(item.direction, normal)),
        met.weight * k_s * mirror_share(point), RayKind::Reflection, item.media);
  spawn(item, met, item.direction, met.weight * tint * (1.0f - k_s), RayKind::Refraction,
        item.media);
  scatter_back(item, met, k_s);
}

}  // namespace amalgam::trace
