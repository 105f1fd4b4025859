#include "trace/media_at.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "trace/surface_point.h"

namespace amalgam::trace {
namespace {

// Materials that the way leaves without having entered them, innermost first.
std::vector<std::uint32_t> materials_left(const EmbreeScene& scene, const glm::vec3& point,
                                          const glm::vec3& direction) {
  constexpr int kMaxSurfaces = 256;  // a bound against meshes that never end
  std::vector<std::uint32_t> entered, left;
  Ray ray{point, direction, std::numeric_limits<float>::infinity()};
  for (int surfaces = 0; surfaces < kMaxSurfaces; ++surfaces) {
    const auto hit = scene.intersect(ray, Visible::Everything);
    if (!hit) break;
    const SurfacePoint met = surface_point(scene, *hit, direction);
    ray.origin = met.ray_origin_on_line(direction);
    const scene::Material& material = scene.scene().materials[met.material];
    if (material.kind != scene::MaterialKind::Dielectric || material.thin) continue;
    const auto found = std::find(entered.begin(), entered.end(), met.material);
    if (met.front) {
      entered.push_back(met.material);
    } else if (found != entered.end()) {
      entered.erase(found);
    } else {
      left.push_back(met.material);
    }
  }
  return left;
}

}  // namespace

Media media_at(const EmbreeScene& scene, const glm::vec3& point) {
  // To the corners of a tetrahedron, turned so that they run along no likely edge or plane. Unit.
  constexpr glm::vec3 kDirections[] = {{0.611f, 0.730f, 0.306f},
                                       {0.532f, -0.690f, -0.491f},
                                       {-0.708f, 0.429f, -0.561f},
                                       {-0.469f, -0.589f, 0.658f}};
  const std::vector<std::uint32_t> left = materials_left(scene, point, kDirections[0]);
  for (const glm::vec3& direction : kDirections) {
    if (left.empty()) return {};
    const std::vector<std::uint32_t> other = materials_left(scene, point, direction);
    if (!std::is_permutation(left.begin(), left.end(), other.begin(), other.end())) return {};
  }
  Media media;
  for (auto outermost = left.rbegin(); outermost != left.rend(); ++outermost) {
    media = media.entered(*outermost);
  }
  return media;
}

}  // namespace amalgam::trace
