// A scene's meshes, textures and materials on the GPU, uploaded once.
#pragma once

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
  Buffer face_normals;        // unit geometric normals in mesh space, by gl_PrimitiveID
  glm::vec3 low{0}, high{0};  // bounds in mesh space, metres
  bool has_uvs = false;
};

// What passes need to know of Scene::instances and their materials.
struct GpuInstanceInfo {
  std::uint32_t mesh = 0;
  std::uint32_t material = 0;
  scene::Role role = scene::Role::Virtual;
  scene::MaterialKind kind = scene::MaterialKind::Diffuse;
  bool textured = false;   // the material has a texture and the mesh has uvs
  bool cut_out = false;    // textured, with an alpha mask
  bool invisible = false;  // its alpha mask leaves nothing
};

// What shaders can do without, because the scene has none of it.
struct SceneFeatures {
  bool textures = false;
  bool real_opaque = false, virtual_opaque = false;  // casters of shadows
  bool real_glass = false, virtual_glass = false;
};
SceneFeatures find_features(const scene::Scene& scene);

class GpuScene {
 public:
  explicit GpuScene(const scene::Scene& scene);  // which need not outlive it

  const std::vector<GpuMesh>& meshes() const { return meshes_; }
  const std::vector<GpuInstanceInfo>& instances() const { return instances_; }

  const std::vector<GpuMaterial>& materials() const { return materials_; }

  // Binds the table that reads textures: the sRGB curve.
  void bind_tables() const;
  // Draws the mesh with its face normals and the material's texture bound.
  void draw(std::uint32_t mesh, std::uint32_t material) const;

  // One triangle that covers clip space, for passes from image to image.
  void draw_screen() const;

 private:
  std::vector<GpuMesh> meshes_;
  std::vector<GpuInstanceInfo> instances_;
  std::vector<Texture> textures_;  // RGBA8UI, sRGB-encoded as in the file
  std::vector<std::optional<std::uint32_t>> texture_of_material_;
  std::vector<GpuMaterial> materials_;
  Buffer srgb_table_;
  VertexArray screen_;
};

}  // namespace amalgam::gl
