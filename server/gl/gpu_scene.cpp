#include "gl/gpu_scene.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <span>

#include "gl/shader_interface.h"
#include "scene/tone_map.h"

namespace amalgam::gl {
namespace {

// In double: the edges' product of a tiny triangle is below what float can hold.
std::vector<glm::vec4> face_normals(const scene::Mesh& mesh) {
  std::vector<glm::vec4> normals;
  normals.reserve(mesh.triangles.size());
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[triangle.x]), b(mesh.positions[triangle.y]),
        c(mesh.positions[triangle.z]);
    normals.emplace_back(glm::vec3(glm::normalize(glm::cross(b - a, c - a))), 0.0f);
  }
  return normals;
}

GpuMesh upload_mesh(const scene::Mesh& mesh) {
  GpuMesh gpu{.vertices = VertexArray(mesh),
              .face_normals = Buffer::of(std::span<const glm::vec4>(face_normals(mesh))),
              .has_uvs = !mesh.uvs.empty()};
  if (!mesh.positions.empty()) gpu.low = gpu.high = mesh.positions.front();
  for (const glm::vec3& position : mesh.positions) {
    gpu.low = glm::min(gpu.low, position);
    gpu.high = glm::max(gpu.high, position);
  }
  return gpu;
}

GpuMaterial describe_material(const scene::Scene& scene, const scene::Material& material) {
  GpuMaterial gpu;
  gpu.base_color = material.base_color;
  gpu.emission = material.emission;
  gpu.metallic = material.metallic;
  gpu.absorption = material.absorption;
  gpu.alpha_cutoff = material.alpha_cutoff.value_or(-1.0f);
  gpu.phong_exponent = scene::phong_terms(material, glm::vec3(1.0f)).exponent;
  gpu.normal_reflectance = scene::normal_reflectance(material.ior);
  gpu.thin = material.thin ? 1 : 0;
  if (material.base_color_texture) {
    const scene::Texture& texture = scene.textures[*material.base_color_texture];
    gpu.wrap = {static_cast<std::uint32_t>(texture.wrap_u),
                static_cast<std::uint32_t>(texture.wrap_v)};
  }
  return gpu;
}

// As four to a vector: std140 would pad single floats to 16 bytes.
Buffer upload_srgb_table() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = scene::srgb_decode(static_cast<std::uint8_t>(i));
  }
  return Buffer::of(std::span<const float>(table));
}

scene::Mesh screen_triangle() {
  scene::Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
  mesh.normals.resize(3);
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

}  // namespace

SceneFeatures find_features(const scene::Scene& scene) {
  SceneFeatures features;
  for (const scene::Instance& instance : scene.instances) {
    const scene::Material& material = scene.materials[instance.material];
    features.textures = features.textures || material.base_color_texture.has_value();
    const bool real = instance.role == scene::Role::Real;
    const bool glass = material.kind == scene::MaterialKind::Dielectric;
    (glass ? (real ? features.real_glass : features.virtual_glass)
           : (real ? features.real_opaque : features.virtual_opaque)) = true;
  }
  return features;
}

GpuScene::GpuScene(const scene::Scene& scene)
    : srgb_table_(upload_srgb_table()), screen_(screen_triangle()) {
  for (const scene::Mesh& mesh : scene.meshes) meshes_.push_back(upload_mesh(mesh));
  for (const scene::Texture& texture : scene.textures) {
    textures_.emplace_back(TextureFormat::Rgba8ui, texture.texels.size());
    textures_.back().upload(texture.texels.data());
  }
  for (const scene::Material& material : scene.materials) {
    texture_of_material_.push_back(material.base_color_texture);
    materials_.push_back(describe_material(scene, material));
  }
  for (const scene::Instance& instance : scene.instances) {
    const scene::Material& material = scene.materials[instance.material];
    const bool textured = material.base_color_texture.has_value() && meshes_[instance.mesh].has_uvs;
    const bool masked = material.alpha_cutoff.has_value();
    instances_.push_back(
        {.mesh = instance.mesh,
         .material = instance.material,
         .role = instance.role,
         .kind = material.kind,
         .textured = textured,
         .cut_out = textured && masked,
         .invisible = !textured && masked && material.base_color.a < *material.alpha_cutoff});
  }
}

void GpuScene::bind_tables() const {
  srgb_table_.bind_uniform(kSrgbTableBinding);
}

void GpuScene::draw_screen() const {
  screen_.draw();
}

void GpuScene::draw(std::uint32_t mesh, std::uint32_t material) const {
  if (const auto& texture = texture_of_material_[material]) {
    textures_[*texture].bind(kBaseColorUnit);
  }
  meshes_[mesh].face_normals.bind_storage(kFaceNormalsBinding);
  meshes_[mesh].vertices.draw();
}

}  // namespace amalgam::gl
