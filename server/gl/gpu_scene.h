// A scene's meshes, textures and materials on the GPU, uploaded once.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "gl/buffer.h"
#include "gl/shader_interface.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "scene/scene.h"

namespace amalgam::gl {

struct GpuMesh {
  VertexArray vertices;
  // By gl_PrimitiveID. xyz: unit geometric normal in mesh space; w: area in uv over area in mesh
  // space.
  Buffer face_normals;
  std::optional<Buffer> second_uv_areas;  // the w for Mesh::second_uvs, one float each
  glm::vec3 low{0}, high{0};              // bounds in mesh space, metres
  bool flat = false;                      // lies in one plane, so it cannot shadow itself
};

// The data of Scene::instances and their materials that passes need.
struct GpuInstanceInfo {
  std::uint32_t mesh = 0;
  std::uint32_t material = 0;
  scene::Role role = scene::Role::Virtual;
  scene::MaterialKind kind = scene::MaterialKind::Diffuse;
  std::uint32_t textures = 0;  // GpuMaterial::textures, without those that the mesh lacks uvs for
  bool detailed = false;       // has textures or vertex colors
  bool cut_out = false;        // has alpha cut-outs: an alpha mask and an alpha that varies
  bool invisible = false;      // its alpha mask cuts out everything
};

// Features that the scene uses. Shaders leave the others out.
struct ShaderFeatures {
  std::uint32_t textures = 0;  // bit n: some surface has a texture in TextureSlot n
  bool second_uvs = false;     // some texture is read at Mesh::second_uvs
  bool vertex_colors = false;
  bool real_opaque = false, virtual_opaque = false;  // shadow casters
  bool real_glass = false, virtual_glass = false;
  bool lone_real_plane = false;  // the only real opaque instance is flat

  bool has_texture(scene::TextureSlot slot) const {
    return (textures >> static_cast<unsigned>(slot) & 1u) != 0;
  }
  bool has_details() const { return textures != 0 || vertex_colors; }
};
ShaderFeatures find_features(const scene::Scene& scene);

class GpuScene {
 public:
  explicit GpuScene(const scene::Scene& scene);  // the scene need not outlive this

  const std::vector<GpuMesh>& meshes() const { return meshes_; }
  const std::vector<GpuInstanceInfo>& instances() const { return instances_; }

  const std::vector<GpuMaterial>& materials() const { return materials_; }
  const ShaderFeatures& features() const { return features_; }

  // Binds the sRGB table, with which shaders decode textures.
  void bind_tables() const;
  // Draws the mesh with its face normals and the material's textures bound.
  void draw(std::uint32_t mesh, std::uint32_t material) const;

 private:
  std::vector<GpuMesh> meshes_;
  std::vector<GpuInstanceInfo> instances_;
  std::vector<Texture> textures_;  // RGBA8UI, encoded as in the file
  std::vector<std::array<std::optional<std::uint32_t>, scene::kTextureSlots>> textures_of_material_;
  std::vector<GpuMaterial> materials_;
  ShaderFeatures features_;
  Buffer srgb_table_;
};

}  // namespace amalgam::gl
