#include "support/reference/world.h"

#include <glm/matrix.hpp>

#include "support/reference/pictures.h"

namespace amalgam::reference {
namespace {

void add_instance(Geometry& geometry, const scene::Mesh& mesh, const glm::dmat4& world_from_mesh,
                  std::uint32_t object) {
  const glm::dmat3 linear(world_from_mesh);
  const glm::dmat3 normal_matrix = glm::transpose(glm::inverse(linear));
  // A mirroring transform turns the corners' order around, but not what is outside.
  const double handedness = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
  for (const glm::uvec3& indices : mesh.triangles) {
    Triangle triangle;
    triangle.object = object;
    for (glm::length_t i = 0; i < 3; ++i) {
      const auto corner = static_cast<std::size_t>(i);
      triangle.corners[corner] = transform_point(world_from_mesh, Vec3(mesh.positions[indices[i]]));
      triangle.normals[corner] = glm::normalize(normal_matrix * Vec3(mesh.normals[indices[i]]));
      if (!mesh.uvs.empty()) triangle.uvs[corner] = Vec2(mesh.uvs[indices[i]]);
    }
    const auto& [a, b, c] = triangle.corners;
    triangle.geometric_normal = handedness * glm::normalize(glm::cross(b - a, c - a));
    geometry.triangles.push_back(triangle);
  }
}

}  // namespace

Geometry make_geometry(const scene::Scene& scene, const scene::AnchoredScene& anchored) {
  Geometry geometry;
  for (const scene::AnchoredInstance& placed : anchored.instances) {
    const scene::Instance& instance = scene.instances[placed.instance];
    const auto object = static_cast<std::uint32_t>(geometry.objects.size());
    geometry.objects.push_back(
        {scene.materials[instance.material], instance.material, instance.role});
    add_instance(geometry, scene.meshes[instance.mesh], glm::dmat4(placed.world_from_mesh), object);
  }
  return geometry;
}

World::World(Geometry geometry, std::span<const scene::Texture> textures)
    : geometry_(std::move(geometry)), textures_(textures) {
  std::vector<Box> boxes;
  for (const Triangle& triangle : geometry_.triangles) boxes.push_back(bounds(triangle));
  for (const Ball& ball : geometry_.balls) boxes.push_back(bounds(ball));
  tree_ = BoundingTree(boxes);
}

Vec4 World::base_color(const Hit& hit) const {
  const scene::Material& material = object(hit).material;
  const Vec4 factor(material.base_color);
  if (!material.base_color_texture) return factor;
  return factor * sample_texture(textures_[*material.base_color_texture], hit.uv);
}

std::optional<Hit> World::closest(Ray ray) const {
  std::optional<Hit> nearest;
  tree_.for_each_candidate(ray, [&](std::uint32_t primitive) {
    const auto hit = intersect_primitive(ray, primitive);
    if (hit && exists(*hit)) {
      nearest = hit;
      ray.t_max = hit->t;
    }
    return true;
  });
  return nearest;
}

std::optional<Hit> World::intersect_primitive(const Ray& ray, std::uint32_t primitive) const {
  if (!is_ball(primitive)) return intersect(ray, geometry_.triangles[primitive]);
  return intersect(ray, geometry_.balls[primitive - geometry_.triangles.size()]);
}

bool World::exists(const Hit& hit) const {
  const auto& cutoff = object(hit).material.alpha_cutoff;
  return !cutoff || base_color(hit).a >= static_cast<double>(*cutoff);
}

}  // namespace amalgam::reference
