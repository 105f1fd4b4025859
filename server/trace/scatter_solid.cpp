// The surface of solid glass or of a liquid: the reflected and the refracted child (eq. 4.7, 4.8).
#include <algorithm>
#include <glm/geometric.hpp>

#include "trace/tile.h"

namespace amalgam::trace {

void Tile::scatter_solid(const RayItem& item, const MetSurface& met, const glm::dvec3& normal) {
  const SurfacePoint& point = met.point;
  const auto& materials = request_.scene.scene().materials;
  const Media beyond = point.front ? item.media.entered(point.material, point.role)
                                   : item.media.left(point.material);
  // A ray that meets the inner side without having entered (an open mesh) still leaves glass.
  const double eta_here = !point.front && !item.media.innermost()
                              ? double{materials[point.material].ior}
                              : refractive_index(item.media, materials);
  const double eta_beyond = refractive_index(beyond, materials);
  const double cos_incident = std::clamp(-glm::dot(item.direction, normal), 0.0, 1.0);
  const auto refracted = refract(item.direction, normal, eta_here, eta_beyond);
  const auto k_s = refracted ? static_cast<float>(reflectance(request_.settings.fresnel,
                                                              cos_incident, eta_here, eta_beyond))
                             : 1.0f;
  spawn(item, met, glm::normalize(reflect(item.direction, normal)),
        met.weight * k_s * mirror_share(point), RayKind::Reflection, item.media);
  if (refracted) {
    const glm::vec3 tint = point.transmission * glm::vec3(point.base_color);
    spawn(item, met, valid_refraction(point.geometric_normal, *refracted),
          met.weight * tint * (1.0f - k_s), RayKind::Refraction, beyond);
  }
  scatter_back(item, met, k_s);
}

}  // namespace amalgam::trace
