#include "gl/gpu_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "gl/shader_interface.h"
#include "scene/light/tone_map.h"
#include "scene/texture_lookup.h"

namespace amalgam::gl {
namespace {

// By scene::TextureSlot.
constexpr std::array<GLuint, scene::kTextureSlots> kUnits{
    kBaseColorUnit, kMetallicRoughnessUnit, kEmissiveUnit, kTransmissionUnit, kNormalUnit};

// In double: the cross product of a tiny triangle's edges underflows in float.
std::vector<glm::vec4> face_normals(const scene::Mesh& mesh) {
  std::vector<glm::vec4> normals;
  normals.reserve(mesh.triangles.size());
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[triangle.x]), b(mesh.positions[triangle.y]),
        c(mesh.positions[triangle.z]);
    normals.emplace_back(glm::vec3(glm::normalize(glm::cross(b - a, c - a))),
                         scene::uv_area_ratio(mesh, mesh.uvs, triangle));
  }
  return normals;
}

std::optional<Buffer> upload_second_uv_areas(const scene::Mesh& mesh) {
  if (mesh.second_uvs.empty()) return std::nullopt;
  std::vector<float> areas;
  for (const glm::uvec3& triangle : mesh.triangles) {
    areas.push_back(scene::uv_area_ratio(mesh, mesh.second_uvs, triangle));
  }
  return Buffer::of(std::span<const float>(areas));
}

// Whether all vertices lie in one plane, to a few roundings of their coordinates.
bool is_flat(const scene::Mesh& mesh) {
  if (mesh.triangles.empty()) return true;
  const glm::uvec3& triangle = mesh.triangles.front();
  const glm::dvec3 a(mesh.positions[triangle.x]), b(mesh.positions[triangle.y]),
      c(mesh.positions[triangle.z]);
  const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
  double extent = 0.0, off = 0.0;
  for (const glm::vec3& position : mesh.positions) {
    const glm::dvec3 way = glm::dvec3(position) - a;
    extent = std::max({extent, glm::length(way), glm::length(glm::dvec3(position))});
    off = std::max(off, std::abs(glm::dot(way, normal)));
  }
  return off <= 1e-6 * extent;
}

GpuMesh upload_mesh(const scene::Mesh& mesh) {
  GpuMesh gpu{.vertices = VertexArray(mesh),
              .face_normals = Buffer::of(std::span<const glm::vec4>(face_normals(mesh))),
              .second_uv_areas = upload_second_uv_areas(mesh)};
  if (!mesh.positions.empty()) gpu.low = gpu.high = mesh.positions.front();
  for (const glm::vec3& position : mesh.positions) {
    gpu.low = glm::min(gpu.low, position);
    gpu.high = glm::max(gpu.high, position);
  }
  gpu.flat = is_flat(mesh);
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
  gpu.roughness = material.roughness;
  gpu.transmission = material.transmission;
  gpu.normal_scale = material.normal_scale;
  for (const scene::TextureSlot slot : scene::kAllTextureSlots) {
    const auto index = material.texture(slot);
    if (!index) continue;
    const scene::Texture& texture = scene.textures[*index];
    const auto wrap = static_cast<std::uint32_t>(texture.wrap_u) |
                      static_cast<std::uint32_t>(texture.wrap_v) << kWrapBits;
    gpu.wraps |= wrap << 2 * kWrapBits * static_cast<unsigned>(slot);
    const glm::uvec2 size(texture.texels.size());
    gpu.map_sizes[static_cast<std::size_t>(slot)] = size.x | size.y << kMapSizeBits;
  }
  return gpu;
}

// GpuMaterial::textures, without those that the mesh lacks coordinates (or, for normal textures,
// tangents) for.
std::uint32_t texture_bits(const scene::Material& material, const scene::Mesh& mesh) {
  std::uint32_t bits = 0;
  for (const scene::TextureSlot slot : scene::kAllTextureSlots) {
    if (!scene::has_texture(material, mesh, slot)) continue;
    if (slot == scene::TextureSlot::Normal && mesh.tangents.empty()) continue;
    bits |= 1u << static_cast<unsigned>(slot);
    if (material.reads_second_uvs(slot))
      bits |= 1u << (kSecondUvsBit + static_cast<unsigned>(slot));
  }
  return bits;
}

// All levels of a texture in one picture: the full size at the left, the smaller ones below each
// other at its right (shaders/texture_lookup.glsl). Not levels of a GL texture, because llvmpipe
// reads four neighbouring fragments at one level, even with an explicit level, and they may belong
// to different triangles.
common::ImageRgba8 mip_atlas(const scene::Texture& texture) {
  if (texture.mips.empty()) return texture.texels;
  const int left = texture.texels.width();
  int below = 0;
  for (const common::ImageRgba8& mip : texture.mips) below += mip.height();
  common::ImageRgba8 atlas(left + texture.mips.front().width(),
                           std::max(texture.texels.height(), below));
  const auto place = [&](const common::ImageRgba8& image, int x0, int y0) {
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) atlas.at(x0 + x, y0 + y) = image.at(x, y);
    }
  };
  place(texture.texels, 0, 0);
  below = 0;
  for (const common::ImageRgba8& mip : texture.mips) {
    place(mip, left, below);
    below += mip.height();
  }
  return atlas;
}

Texture upload_texture(const scene::Texture& texture) {
  const common::ImageRgba8 atlas = mip_atlas(texture);
  Texture gpu(TextureFormat::Rgba8ui, atlas.size());
  gpu.upload(atlas.data());
  return gpu;
}

// Four to a vector: std140 would pad single floats to 16 bytes.
Buffer upload_srgb_table() {
  std::array<float, kSrgbTableSize> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = scene::srgb_decode(static_cast<std::uint8_t>(i));
  }
  return Buffer::of(std::span<const float>(table));
}

}  // namespace

ShaderFeatures find_features(const scene::Scene& scene) {
  ShaderFeatures features;
  int real_opaque = 0;
  bool all_flat = true;
  for (const scene::Instance& instance : scene.instances) {
    const scene::Material& material = scene.materials[instance.material];
    const scene::Mesh& mesh = scene.meshes[instance.mesh];
    const std::uint32_t bits = texture_bits(material, mesh);
    features.textures |= bits & ((1u << kSecondUvsBit) - 1u);
    features.second_uvs = features.second_uvs || bits >> kSecondUvsBit != 0;
    features.vertex_colors = features.vertex_colors || !mesh.colors.empty();
    const bool real = instance.role == scene::Role::Real;
    const bool glass = material.kind == scene::MaterialKind::Dielectric;
    if (real && !glass) {
      ++real_opaque;
      all_flat = all_flat && is_flat(mesh);
    }
    (glass ? (real ? features.real_glass : features.virtual_glass)
           : (real ? features.real_opaque : features.virtual_opaque)) = true;
  }
  features.lone_real_plane = real_opaque == 1 && all_flat;
  return features;
}

GpuScene::GpuScene(const scene::Scene& scene)
    : features_(find_features(scene)), srgb_table_(upload_srgb_table()) {
  for (const scene::Mesh& mesh : scene.meshes) meshes_.push_back(upload_mesh(mesh));
  for (const scene::Texture& texture : scene.textures) textures_.push_back(upload_texture(texture));
  for (const scene::Material& material : scene.materials) {
    auto& textures = textures_of_material_.emplace_back();
    for (std::size_t slot = 0; slot < textures.size(); ++slot) {
      textures[slot] = material.texture(scene::kAllTextureSlots[slot]);
    }
    materials_.push_back(describe_material(scene, material));
  }
  for (const scene::Instance& instance : scene.instances) {
    const scene::Material& material = scene.materials[instance.material];
    const scene::Mesh& mesh = scene.meshes[instance.mesh];
    const std::uint32_t textures = texture_bits(material, mesh);
    const bool colored =
        scene::has_texture(material, mesh, scene::TextureSlot::BaseColor) || !mesh.colors.empty();
    const bool masked = material.alpha_cutoff.has_value();
    instances_.push_back(
        {.mesh = instance.mesh,
         .material = instance.material,
         .role = instance.role,
         .kind = material.kind,
         .textures = textures,
         .detailed = textures != 0 || colored,
         .cut_out = colored && masked,
         .invisible = !colored && masked && material.base_color.a < *material.alpha_cutoff});
  }
}

void GpuScene::bind_tables() const {
  srgb_table_.bind_uniform(kSrgbTableBinding);
}

void GpuScene::draw(std::uint32_t mesh, std::uint32_t material) const {
  for (std::size_t slot = 0; slot < kUnits.size(); ++slot) {
    if (const auto& texture = textures_of_material_[material][slot]) {
      textures_[*texture].bind(kUnits[slot]);
    }
  }
  if (meshes_[mesh].second_uv_areas) {
    meshes_[mesh].second_uv_areas->bind_storage(kSecondUvAreasBinding);
  }
  meshes_[mesh].face_normals.bind_storage(kFaceNormalsBinding);
  meshes_[mesh].vertices.draw();
}

}  // namespace amalgam::gl
