#include "trace/media_at.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "trace/visibility_walk.h"

namespace amalgam::trace {
namespace {

struct Solid {
  std::uint32_t material = 0;
  scene::Role role = scene::Role::Virtual;
  bool operator==(const Solid&) const = default;
};

// Solids that the ray leaves without having entered them, innermost first.
std::vector<Solid> materials_left(const EmbreeScene& scene, const glm::vec3& point,
                                  const glm::vec3& direction) {
  std::vector<Solid> entered, left;
  const Ray ray{point, direction, std::numeric_limits<float>::infinity()};
  walk_visibility(
      scene, glm::dvec3(point), ray, Visible::Everything, [&](const SurfacePoint& met, double) {
        const scene::Material& material = scene.scene().materials[met.material];
        const bool solid = material.kind == scene::MaterialKind::Dielectric && !material.thin;
        const Solid here{met.material, met.role};
        const auto found = std::find(entered.begin(), entered.end(), here);
        if (!solid) {
          // No medium begins or ends there.
        } else if (met.front) {
          entered.push_back(here);
        } else if (found != entered.end()) {
          entered.erase(found);
        } else {
          left.push_back(here);
        }
        return std::optional(Visible::Everything);
      });
  return left;
}

}  // namespace

Media media_at(const EmbreeScene& scene, const glm::vec3& point) {
  // Unit, to the corners of a tetrahedron that is turned so that no likely edge or plane is
  // parallel to them.
  constexpr glm::vec3 kDirections[] = {{0.611f, 0.730f, 0.306f},
                                       {0.532f, -0.690f, -0.491f},
                                       {-0.708f, 0.429f, -0.561f},
                                       {-0.469f, -0.589f, 0.658f}};
  const std::vector<Solid> left = materials_left(scene, point, kDirections[0]);
  for (const glm::vec3& direction : kDirections) {
    if (left.empty()) return {};
    const std::vector<Solid> other = materials_left(scene, point, direction);
    if (!std::is_permutation(left.begin(), left.end(), other.begin(), other.end())) return {};
  }
  Media media;
  for (auto outermost = left.rbegin(); outermost != left.rend(); ++outermost) {
    media = media.entered(outermost->material, outermost->role);
  }
  return media;
}

}  // namespace amalgam::trace
