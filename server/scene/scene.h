// A loaded scene as plain data: glTF, checked and resolved, independent of any renderer.
//
// Metres, right-handed, +Y up. Everything is in an *anchor* frame: the frame on a marker (origin at
// its centre, +Y out of the paper, +X along its right). This is the world marker's frame unless a
// node names another marker.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/image.h"
#include "scene/light/environment.h"
#include "scene/light/light.h"
#include "scene/material.h"

namespace amalgam::scene {

// A *real* object is a model of something the camera sees already; a *virtual* one is added.
enum class Role : std::uint8_t { Real, Virtual };

// One glTF primitive. Indices are in range, positions finite and normals unit by construction
// (scene/gltf/loader): zero-area triangles are dropped, missing normals computed flat.
struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  // as many as positions
  // As many as positions, or none. Texture transforms are already applied.
  std::vector<glm::vec2> uvs;
  std::vector<glm::vec2> second_uvs;  // for textures with another placement (Material)
  std::vector<glm::vec4> colors;      // linear; multiply the base color, alpha too
  // xyz: along +u, zero if undefined. w = +-1: cross(normal, tangent) w is the normal texture's +y.
  // Only for materials with a normal texture.
  std::vector<glm::vec4> tangents;
  std::vector<glm::uvec3> triangles;
};

enum class Wrap : std::uint8_t { Repeat, Mirror, Clamp };

// The coordinates at which the material's texture is read on this mesh; empty: it is not read.
inline const std::vector<glm::vec2>& uvs_of(const Mesh& mesh, const Material& material,
                                            TextureSlot slot) {
  return material.reads_second_uvs(slot) ? mesh.second_uvs : mesh.uvs;
}
inline bool has_texture(const Material& material, const Mesh& mesh, TextureSlot slot) {
  return material.texture(slot) && !uvs_of(mesh, material, slot).empty();
}

// Color textures are sRGB-encoded as in the file, others linear (material.h says which); alpha is
// linear. uv (0, 0) is the top left corner.
struct Texture {
  common::ImageRgba8 texels;
  // Half the size each, down to 1x1; encoded like the texels. Empty: only the full size exists.
  std::vector<common::ImageRgba8> mips;
  Wrap wrap_u = Wrap::Repeat;
  Wrap wrap_v = Wrap::Repeat;
};

struct Instance {
  std::string node;                  // for messages
  std::uint32_t mesh = 0;            // index into Scene::meshes
  std::uint32_t material = 0;        // index into Scene::materials
  glm::dmat4 anchor_from_mesh{1.0};  // affine, may scale and mirror; condition <= 1e6
  std::optional<int> marker{};       // the marker it is bound to; none: the world marker
  Role role = Role::Virtual;
};

// KHR_lights_punctual. Point and spot: candela; directional: lux (taken as radiance units x sr).
struct PunctualLight {
  using Kind = Light::Kind;
  std::string node;
  Kind kind = Kind::Directional;
  glm::vec3 intensity{0.0f};                       // color times intensity, linear
  float range = 0.0f;                              // metres; 0 = unlimited
  float cos_inner = 1.0f, cos_outer = 0.7071068f;  // spot cone
  glm::dmat4 anchor_from_light{1.0};               // the light shines along its -Z
  std::optional<int> marker{};
};

struct World {
  int marker = 0;  // defines the world frame
  std::string dictionary = "DICT_6X6_250";
  double marker_length = 0.05;  // metres
};

struct Scene {
  std::string path;  // of the file that it was read from; empty if it was made otherwise
  World world;
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Instance> instances;
  std::vector<PunctualLight> punctual_lights;
  std::optional<Environment> environment;
  std::vector<std::string> notes;  // the loader's repairs and ignored elements, one line each
  // What its author hardly wants (likely_mistakes.h), one line each; programs say it at start.
  std::vector<std::string> warnings;
};

}  // namespace amalgam::scene
