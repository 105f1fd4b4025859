#include "scene/glass_winding.h"

#include <algorithm>
#include <limits>

#include "scene/bounds.h"
#include "scene/closed_mesh.h"

namespace amalgam::scene {
namespace {

bool is_solid_glass(const Scene& scene, const Instance& instance) {
  const Material& material = scene.materials[instance.material];
  return material.kind == MaterialKind::Dielectric && !material.thin;
}

Bounds placed(const Bounds& bounds, const Instance& instance) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Bounds box{glm::vec3(kInfinity), glm::vec3(-kInfinity)};
  for (const glm::dvec3& corner : placed_corners(bounds, glm::mat4(instance.anchor_from_mesh))) {
    box.low = glm::min(box.low, glm::vec3(corner));
    box.high = glm::max(box.high, glm::vec3(corner));
  }
  return box;
}

bool is_inside(const Bounds& inner, const Bounds& outer) {
  return glm::all(glm::greaterThanEqual(inner.low, outer.low)) &&
         glm::all(glm::lessThanEqual(inner.high, outer.high));
}

}  // namespace

void turn_glass_outward(Scene& scene) {
  const auto bounds = mesh_bounds(scene);
  std::vector<Bounds> boxes;
  for (const Instance& instance : scene.instances) {
    boxes.push_back(placed(bounds[instance.mesh], instance));
  }
  for (std::uint32_t m = 0; m < scene.meshes.size(); ++m) {
    bool is_glass = false, is_other = false, may_be_hollow = false;
    std::string node;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      const Instance& instance = scene.instances[i];
      if (instance.mesh != m) continue;
      node = instance.node;
      (is_solid_glass(scene, instance) ? is_glass : is_other) = true;
      for (std::size_t k = 0; k < scene.instances.size(); ++k) {
        may_be_hollow = may_be_hollow || (k != i && scene.instances[k].marker == instance.marker &&
                                          is_solid_glass(scene, scene.instances[k]) &&
                                          is_inside(boxes[i], boxes[k]));
      }
    }
    Mesh& mesh = scene.meshes[m];
    if (!is_glass || is_other || may_be_hollow || !is_closed(mesh)) continue;
    const auto warn = [&](const char* what) {
      scene.warnings.push_back("node " + node + ": its glass has " + what +
                               " that point inward; turned outward");
    };
    if (signed_volume(mesh) < 0.0) {
      flip_winding(mesh);
      warn("triangles");
    }
    if (normals_along_winding(mesh) < 0.0) {
      flip_normals(mesh);
      warn("normals");
    }
  }
}

}  // namespace amalgam::scene
