// The interface of C++ and GLSL: bindings, locations, limits and the layout of buffers. Shaders get
// the numbers from here, by name (gl/shader_constants.h). The structs are repeated in
// shaders/interface.glsl.
//
// Nearly everything is in uniform blocks, bound by range if there is one entry for each draw.
// Software GL reads uniform blocks once for all fragments, but shader storage once for each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "scene/material.h"

namespace amalgam::gl {

// Uniform blocks.
constexpr unsigned kFrameBinding = 0;
constexpr unsigned kSrgbTableBinding = 1;
constexpr unsigned kSurfaceBinding = 2;
constexpr unsigned kLightsBinding = 3;
constexpr unsigned kShadowLayerBinding = 4;
// Shader storage.
constexpr unsigned kFaceNormalsBinding = 0;
constexpr unsigned kSecondUvAreasBinding = 1;
// Texture units.
constexpr unsigned kBaseColorUnit = 0;
constexpr unsigned kMaskUnit = 1;
constexpr unsigned kShadowMapUnit = 2;  // and the next three, by CasterClass
constexpr unsigned kTileLightsUnit = 6;
constexpr unsigned kMetallicRoughnessUnit = 8;
constexpr unsigned kEmissiveUnit = 9;
constexpr unsigned kTransmissionUnit = 10;
constexpr unsigned kNormalUnit = 11;
// Vertex attributes.
constexpr unsigned kPositionAttribute = 0;
constexpr unsigned kNormalAttribute = 1;
constexpr unsigned kUvAttribute = 2;
constexpr unsigned kColorAttribute = 3;
constexpr unsigned kTangentAttribute = 4;
constexpr unsigned kSecondUvAttribute = 5;
// Uniform locations.
constexpr int kLightCountLocation = 1;
constexpr int kShadowMapsPresentLocation = 2;  // bit i: the map of CasterClass i is bound
constexpr int kMaskStepLocation = 3;
constexpr int kSamplesOfTileLocation = 4;
constexpr int kWhiteSurfacesLocation = 5;
// The outputs of shade_diffuse.frag, as indices into Framebuffer::Attachments::colors.
constexpr int kMixedOutput = 0;
constexpr int kRealOutput = 1;

// As many as fit into 64 KiB, the size of a uniform block on every desktop driver.
constexpr std::size_t kMaxLights = 512;
constexpr std::size_t kFewSuns = 8;  // directional lights that shade_diffuse.frag unrolls

// Each class has its own shadow maps.
enum class CasterClass : std::uint8_t { RealOpaque, VirtualOpaque, RealGlass, VirtualGlass };
constexpr std::size_t kCasterClasses = 4;
constexpr unsigned kCubeSides = 6;
// A shadow look-up follows the receiver's plane to the texels around it, as if the light fell on it
// at no smaller cosine than this. The casters' own offset (pipeline_state.cpp) covers the rest down
// to half of it. Smaller ones would let a caster far behind a surface seem to shadow it.
constexpr double kLeastShadowCosine = 1.0 / 64.0;

// Metres; nearer surfaces are not drawn. A thousandth of the smallest scenes, which are a
// millimetre across. It costs nothing: depth is a float that falls with the distance, so its
// relative precision is the same everywhere.
constexpr double kNearPlane = 1e-6;

// Bits of a sample in the mask (passes::SampleMask), and of GpuSurface::flags.
constexpr std::uint8_t kVirtualFlag = 1;
constexpr std::uint8_t kSpecularFlag = 2;
constexpr std::uint8_t kSurfaceFlag = 4;

constexpr std::size_t kSrgbTableSize = 256;  // a float for each byte, four to a vector
// How GpuMaterial packs the values of each texture slot.
constexpr unsigned kSecondUvsBit = 8;  // of slot 0, in textures
constexpr unsigned kWrapBits = 2;
constexpr unsigned kMapSizeBits = 16;
static_assert(scene::kTextureSlots <= kSecondUvsBit && 2 * kWrapBits * scene::kTextureSlots <= 32);

// The greatest alignment that a driver may require for a range of a uniform buffer.
constexpr std::size_t kRangeAlignment = 256;

struct GpuFrame {  // std140
  glm::vec3 eye_in_world{0.0f};
  float sample_spread = 0.0f;  // angle between neighbouring samples, radians
};

struct GpuMaterial {  // std140
  glm::vec4 base_color{1.0f};
  glm::vec3 emission{0.0f};
  float metallic = 0.0f;
  glm::vec3 absorption{0.0f};  // 1/m
  float alpha_cutoff = -1.0f;  // below 0: no alpha cut-outs
  float phong_exponent = 0.0f;
  float normal_reflectance = 0.0f;  // dielectrics: Schlick's R_m
  std::uint32_t thin = 0;
  // Bit n: TextureSlot n is used; bit kSecondUvsBit + n: it is read at the second uvs.
  std::uint32_t textures = 0;
  std::uint32_t wraps = 0;  // kWrapBits each: scene::Wrap of u, then of v, slot after slot
  float roughness = 1.0f;
  float transmission = 1.0f;
  float normal_scale = 1.0f;
  // By scene::TextureSlot: width, and height above kMapSizeBits.
  std::array<std::uint32_t, scene::kTextureSlots> map_sizes{};
  std::array<std::uint32_t, 3> unused{};
};
static_assert(sizeof(GpuMaterial) == 112);

// One for each drawn instance.
struct alignas(kRangeAlignment) GpuSurface {  // std140
  glm::mat4 clip_from_mesh{1.0f};
  glm::mat4 world_from_mesh{1.0f};
  // Upper 3x3: cofactors times the determinant's sign, divided by a positive scale near the largest
  // one. Last element: the scale times the sign.
  glm::mat4 normal_from_mesh{1.0f};
  GpuMaterial material;
  std::uint32_t flags = 0;  // the instance's value in the mask
};
static_assert(offsetof(GpuSurface, flags) == 304);

struct GpuLight {  // std140
  glm::vec3 to_light{0.0f};
  std::uint32_t kind = 0;  // scene::Light::Kind
  glm::vec3 position{0.0f};
  float range = 0.0f;
  glm::vec3 intensity{0.0f};
  float cos_inner = 1.0f;
  float cos_outer = 0.0f;
  std::uint32_t first_layer = 0;
  std::uint32_t layer_count = 1;  // 1, or kCubeSides: +x -x +y -y +z -z
  // How much the map's depth changes from texel to texel along a plane with the normal n, divided
  // by n.x / n.l (perspective: and by the distance from the light). x: a row of clip_from_world.
  float plane_step = 0.0f;
  // Of its only layer. For a cube, the first element is the tangent of its sides' half angle.
  glm::mat4 clip_from_world{1.0f};
};
static_assert(sizeof(GpuLight) * kMaxLights == 65536);

// For drawing one layer of the shadow maps.
struct alignas(kRangeAlignment) GpuShadowLayer {  // std140
  glm::mat4 clip_from_world{1.0f};
  glm::vec3 eye{0.0f};  // perspective: the light's position; parallel: unit vector to the light
  std::uint32_t perspective = 0;
};

}  // namespace amalgam::gl
