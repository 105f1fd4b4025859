#include "scene/glass_winding.h"

#include <algorithm>
#include <limits>
#include <map>

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

struct Body {
  const Instance* instance;
  Bounds box;  // in its anchor's frame
};

std::vector<Body> solid_glass(const Scene& scene) {
  std::map<std::uint32_t, Bounds> bounds;  // of the meshes
  std::vector<Body> bodies;
  for (const Instance& instance : scene.instances) {
    if (!is_solid_glass(scene, instance)) continue;
    const auto [of_mesh, is_new] = bounds.try_emplace(instance.mesh);
    if (is_new) of_mesh->second = bounds_of(scene.meshes[instance.mesh]);
    bodies.push_back({&instance, placed(of_mesh->second, instance)});
  }
  return bodies;
}

bool lies_in_another(const Body& body, const std::vector<Body>& glass) {
  return std::any_of(glass.begin(), glass.end(), [&](const Body& other) {
    return other.instance != body.instance && other.instance->marker == body.instance->marker &&
           is_inside(body.box, other.box);
  });
}

}  // namespace

void turn_glass_outward(Scene& scene) {
  const auto glass = solid_glass(scene);
  if (glass.empty()) return;
  // Every body may lie in every other: more are not compared.
  constexpr std::size_t kMostBodies = 10'000;
  if (glass.size() > kMostBodies) {
    scene.notes.emplace_back(
        "more than 10,000 bodies of glass: not tested whether they face outward");
    return;
  }
  std::vector<bool> is_other(scene.meshes.size(), false);
  for (const Instance& instance : scene.instances) {
    if (!is_solid_glass(scene, instance)) is_other[instance.mesh] = true;
  }
  std::map<std::uint32_t, std::vector<const Body*>> by_mesh;
  for (const Body& body : glass) by_mesh[body.instance->mesh].push_back(&body);
  for (const auto& [m, bodies] : by_mesh) {
    const bool may_be_hollow = std::any_of(bodies.begin(), bodies.end(), [&](const Body* body) {
      return lies_in_another(*body, glass);
    });
    const std::string& node = bodies.back()->instance->node;
    Mesh& mesh = scene.meshes[m];
    if (is_other[m] || may_be_hollow || !is_closed(mesh)) continue;
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
