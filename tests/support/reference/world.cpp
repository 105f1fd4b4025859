#include "support/reference/world.h"

#include <glm/matrix.hpp>

namespace amalgam::reference {
namespace {

double area(const Vec3& ab, const Vec3& ac) {
  return 0.5 * glm::length(glm::cross(ab, ac));
}

double uv_per_area(const Triangle& triangle, const TriangleAttributes& attributes,
                   std::size_t set) {
  const auto& [a, b, c] = attributes.corners;
  const Vec3 ab(b.uvs[set] - a.uvs[set], 0.0), ac(c.uvs[set] - a.uvs[set], 0.0);
  const auto& [p, q, r] = triangle.corners;
  return area(ab, ac) / area(q - p, r - p);
}

VertexAttributes make_attributes(const scene::Mesh& mesh, const glm::dmat3& linear,
                                 std::uint32_t vertex) {
  VertexAttributes result;
  if (!mesh.uvs.empty()) result.uvs[0] = Vec2(mesh.uvs[vertex]);
  if (!mesh.second_uvs.empty()) result.uvs[1] = Vec2(mesh.second_uvs[vertex]);
  if (!mesh.colors.empty()) result.color = Vec4(mesh.colors[vertex]);
  if (!mesh.tangents.empty()) {
    const Vec3 tangent(mesh.tangents[vertex]);
    const double handedness = static_cast<double>(mesh.tangents[vertex].w);
    result.tangent = linear * tangent;
    result.bitangent = linear * (handedness * glm::cross(Vec3(mesh.normals[vertex]), tangent));
  }
  return result;
}

double coordinate_size(const scene::Mesh& mesh, const glm::dmat4& world_from_mesh) {
  double farthest = 0.0;
  for (const glm::vec3& position : mesh.positions) {
    farthest = std::max(farthest, glm::length(glm::dmat3(world_from_mesh) * Vec3(position)));
  }
  return farthest + glm::length(Vec3(world_from_mesh[3]));
}

// A texture that the mesh says no place of is not read.
scene::Material placed_material(const scene::Mesh& mesh, scene::Material material) {
  using scene::TextureSlot;
  const auto keep = [&](std::optional<std::uint32_t>& texture, TextureSlot slot) {
    if (scene::uvs_of(mesh, material, slot).empty()) texture.reset();
  };
  keep(material.base_color_texture, TextureSlot::BaseColor);
  keep(material.metallic_roughness_texture, TextureSlot::MetallicRoughness);
  keep(material.emissive_texture, TextureSlot::Emissive);
  keep(material.transmission_texture, TextureSlot::Transmission);
  keep(material.normal_texture, TextureSlot::Normal);
  return material;
}

void add_instance(Geometry& geometry, const scene::Mesh& mesh, const glm::dmat4& world_from_mesh,
                  std::uint32_t object) {
  const glm::dmat3 linear(world_from_mesh);
  const glm::dmat3 normal_matrix = glm::transpose(glm::inverse(linear));
  // A mirroring transform turns the corners' order around, but not what is outside.
  const double handedness = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
  for (const glm::uvec3& indices : mesh.triangles) {
    Triangle triangle;
    TriangleAttributes attributes;
    triangle.object = object;
    for (glm::length_t i = 0; i < 3; ++i) {
      const auto corner = static_cast<std::size_t>(i);
      triangle.corners[corner] = transform_point(world_from_mesh, Vec3(mesh.positions[indices[i]]));
      // Not unit: what is interpolated is the mesh's normal, however the instance stretches it.
      triangle.normals[corner] = normal_matrix * Vec3(mesh.normals[indices[i]]);
      attributes.corners[corner] = make_attributes(mesh, linear, indices[i]);
    }
    const auto& [a, b, c] = triangle.corners;
    triangle.geometric_normal = handedness * glm::normalize(glm::cross(b - a, c - a));
    for (const std::size_t set : {0u, 1u}) {
      attributes.uv_per_area[set] = uv_per_area(triangle, attributes, set);
    }
    geometry.triangles.push_back(triangle);
    geometry.attributes.push_back(attributes);
  }
}

}  // namespace

Geometry make_geometry(const scene::Scene& scene, const scene::AnchoredScene& anchored) {
  Geometry geometry;
  for (const scene::AnchoredInstance& placed : anchored.instances) {
    const scene::Instance& instance = scene.instances[placed.instance];
    const auto object = static_cast<std::uint32_t>(geometry.objects.size());
    const scene::Mesh& mesh = scene.meshes[instance.mesh];
    geometry.objects.push_back({placed_material(mesh, scene.materials[instance.material]),
                                instance.material, instance.role,
                                coordinate_size(mesh, placed.world_from_mesh)});
    add_instance(geometry, mesh, glm::dmat4(placed.world_from_mesh), object);
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

SurfacePlace World::place(const Hit& hit) const {
  static const TriangleAttributes of_a_ball;
  const TriangleAttributes& attributes =
      is_ball(hit.primitive) ? of_a_ball : geometry_.attributes[hit.primitive];
  return {object(hit).material, attributes, hit, textures_};
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
  auto hit = is_ball(primitive)
                 ? intersect(ray, geometry_.balls[primitive - geometry_.triangles.size()])
                 : intersect(ray, geometry_.triangles[primitive]);
  if (hit) hit->primitive = primitive;
  return hit;
}

bool World::exists(const Hit& hit) const {
  const auto& cutoff = object(hit).material.alpha_cutoff;
  return !cutoff || base_color(place(hit)).a >= static_cast<double>(*cutoff);
}

}  // namespace amalgam::reference
