#include "support/scene_builders.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <utility>

namespace amalgam::test_support {
namespace {

void append_quad(scene::Mesh& mesh, const glm::vec3& centre, const glm::vec3& half_u,
                 const glm::vec3& half_v) {
  const auto base = static_cast<unsigned>(mesh.positions.size());
  const glm::vec3 normal = glm::normalize(glm::cross(half_u, half_v));
  constexpr std::array<glm::vec2, 4> kCorners = {glm::vec2(-1, -1), glm::vec2(1, -1),
                                                 glm::vec2(1, 1), glm::vec2(-1, 1)};
  for (const glm::vec2& corner : kCorners) {
    mesh.positions.push_back(centre + corner.x * half_u + corner.y * half_v);
    mesh.normals.push_back(normal);
    mesh.uvs.emplace_back(0.5f + 0.5f * corner.x, 0.5f - 0.5f * corner.y);
  }
  mesh.triangles.emplace_back(base, base + 1, base + 2);
  mesh.triangles.emplace_back(base, base + 2, base + 3);
}

}  // namespace

scene::Mesh make_quad(const glm::vec3& centre, const glm::vec3& half_u, const glm::vec3& half_v) {
  scene::Mesh mesh;
  mesh.name = "quad";
  append_quad(mesh, centre, half_u, half_v);
  return mesh;
}

scene::Mesh make_floor(float height, float half_side) {
  return make_quad({0, height, 0}, {half_side, 0, 0}, {0, 0, -half_side});
}

scene::Mesh make_box(const glm::vec3& low, const glm::vec3& high) {
  scene::Mesh mesh;
  mesh.name = "box";
  const glm::vec3 centre = 0.5f * (low + high), half = 0.5f * (high - low);
  const glm::vec3 x(half.x, 0, 0), y(0, half.y, 0), z(0, 0, half.z);
  append_quad(mesh, centre + x, -z, y);
  append_quad(mesh, centre - x, z, y);
  append_quad(mesh, centre + y, x, -z);
  append_quad(mesh, centre - y, x, z);
  append_quad(mesh, centre + z, x, y);
  append_quad(mesh, centre - z, -x, y);
  return mesh;
}

scene::Mesh make_sphere(const glm::vec3& centre, float radius, int slices, int stacks) {
  scene::Mesh mesh;
  mesh.name = "sphere";
  const auto row_length = static_cast<unsigned>(slices) + 1;
  for (int row = 0; row <= stacks; ++row) {
    const double polar = std::numbers::pi * row / stacks;  // 0 at +y
    for (int column = 0; column <= slices; ++column) {
      const double around = 2.0 * std::numbers::pi * column / slices;
      const glm::vec3 normal(glm::dvec3(std::sin(polar) * std::cos(around), std::cos(polar),
                                        -std::sin(polar) * std::sin(around)));
      mesh.positions.push_back(centre + radius * normal);
      mesh.normals.push_back(normal);
      mesh.uvs.emplace_back(static_cast<float>(column) / static_cast<float>(slices),
                            static_cast<float>(row) / static_cast<float>(stacks));
    }
  }
  for (unsigned row = 0; row < static_cast<unsigned>(stacks); ++row) {
    for (unsigned column = 0; column < static_cast<unsigned>(slices); ++column) {
      const unsigned above = row * row_length + column, below = above + row_length;
      if (row > 0) mesh.triangles.emplace_back(above, below, above + 1);
      if (row + 1 < static_cast<unsigned>(stacks))
        mesh.triangles.emplace_back(above + 1, below, below + 1);
    }
  }
  return mesh;
}

scene::Material make_diffuse(const glm::vec3& base_color, float roughness) {
  scene::Material material;
  material.name = "diffuse";
  material.base_color = glm::vec4(base_color, 1.0f);
  material.roughness = roughness;
  return material;
}

scene::Material make_mirror(const glm::vec3& base_color) {
  scene::Material material;
  material.name = "mirror";
  material.kind = scene::MaterialKind::Mirror;
  material.base_color = glm::vec4(base_color, 1.0f);
  material.metallic = 1.0f;
  material.roughness = 0.0f;
  return material;
}

scene::Material make_glass(float ior, const glm::vec3& absorption) {
  scene::Material material;
  material.name = "glass";
  material.kind = scene::MaterialKind::Dielectric;
  material.roughness = 0.0f;
  material.ior = ior;
  material.absorption = absorption;
  return material;
}

scene::Instance& add_object(scene::Scene& scene, scene::Mesh mesh, scene::Material material,
                            scene::Role role, const glm::mat4& anchor_from_mesh) {
  scene::Instance instance;
  instance.node = mesh.name + std::to_string(scene.instances.size());
  instance.mesh = static_cast<std::uint32_t>(scene.meshes.size());
  instance.material = static_cast<std::uint32_t>(scene.materials.size());
  instance.anchor_from_mesh = anchor_from_mesh;
  instance.role = role;
  scene.meshes.push_back(std::move(mesh));
  scene.materials.push_back(std::move(material));
  return scene.instances.emplace_back(std::move(instance));
}

scene::Light make_sun(const glm::vec3& to_light, const glm::vec3& irradiance) {
  scene::Light light;
  light.to_light = glm::normalize(to_light);
  light.intensity = irradiance;
  return light;
}

scene::Light make_point_light(const glm::vec3& position, const glm::vec3& intensity) {
  scene::Light light;
  light.kind = scene::Light::Kind::Point;
  light.position = position;
  light.intensity = intensity;
  return light;
}

common::CameraModel make_pinhole(int width, int height, double focal_length) {
  common::CameraModel camera;
  camera.width = width;
  camera.height = height;
  camera.fx = camera.fy = focal_length;
  camera.cx = 0.5 * (width - 1);
  camera.cy = 0.5 * (height - 1);
  return camera;
}

glm::dmat4 look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
  const glm::dvec3 forward = glm::normalize(target - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
  const glm::dvec3 down = glm::cross(forward, right);
  glm::dmat4 camera_from_world(1.0);
  const std::array<glm::dvec3, 3> rows = {right, down, forward};
  for (int row = 0; row < 3; ++row) {
    const glm::dvec3& axis = rows[static_cast<std::size_t>(row)];
    for (int column = 0; column < 3; ++column) camera_from_world[column][row] = axis[column];
    camera_from_world[3][row] = -glm::dot(axis, eye);
  }
  return camera_from_world;
}

common::MarkerPose make_pose(int marker, const glm::dmat4& camera_from_anchor) {
  const glm::dmat4 camera_from_marker =
      camera_from_anchor * common::rigid_inverse(common::opencv_marker_from_gltf());
  return {marker, glm::quat_cast(camera_from_marker), glm::dvec3(camera_from_marker[3])};
}

passes::RenderView make_view(const scene::Scene& scene, const common::CameraModel& camera,
                             const glm::dmat4& camera_from_world, std::vector<scene::Light> lights,
                             int samples_per_side) {
  passes::RenderView view;
  view.camera = camera;
  view.ideal = camera;
  view.scene.camera_from_world = camera_from_world;
  view.scene.world_marker = scene.world.marker;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    view.scene.instances.push_back({i, scene.instances[i].anchor_from_mesh});
  }
  view.lights = std::move(lights);
  view.samples_per_side = samples_per_side;
  return view;
}

}  // namespace amalgam::test_support
