// Textures, vertex colors and bent normals show the same through the rasteriser and the tracer.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/mesh_tangents.h"
#include "scene/mip_chain.h"
#include "support/scene_builders.h"
#include "trace/tracer.h"
#include "unit/passes/raster_rig.h"

namespace amalgam::passes {
namespace {

using namespace test_support;

scene::Texture noise_texture(int width, int height, scene::TexelEncoding encoding,
                             const glm::ivec3& low, const glm::ivec3& high) {
  std::uint32_t noise = static_cast<std::uint32_t>(width + 7 * height);
  scene::Texture texture{.texels = common::ImageRgba8(width, height), .mips = {}};
  for (common::Rgba8& texel : texture.texels.pixels()) {
    for (int i = 0; i < 3; ++i) {
      noise = noise * 1664525u + 1013904223u;
      texel[i] = static_cast<std::uint8_t>(low[i] + static_cast<int>(noise >> 24) *
                                                        (high[i] - low[i]) / 255);
    }
    texel.w = static_cast<std::uint8_t>(noise >> 16);
  }
  texture.mips = scene::make_mips(texture.texels, encoding);
  return texture;
}

// A floor with everything, from near by to far away, so that every level of detail occurs.
scene::Scene everything_scene(const glm::mat4& world_from_mesh) {
  using enum scene::TexelEncoding;
  scene::Scene scene;
  scene.textures = {noise_texture(37, 20, Srgb, {0, 0, 0}, {255, 255, 255}),
                    noise_texture(16, 16, Linear, {0, 60, 0}, {255, 255, 255}),
                    noise_texture(8, 32, Srgb, {0, 0, 0}, {255, 255, 255}),
                    noise_texture(32, 32, Linear, {90, 90, 200}, {165, 165, 255})};
  scene.textures[2].wrap_u = scene::Wrap::Mirror;
  scene::Material material = make_diffuse({0.9f, 0.8f, 0.7f}, 0.8f);
  material.metallic = 0.7f;
  material.emission = {0.3f, 0.2f, 0.1f};
  material.base_color_texture = 0;
  material.metallic_roughness_texture = 1;
  material.emissive_texture = 2;
  material.normal_texture = 3;
  material.normal_scale = 0.8f;
  material.second_uv_slots = 1u << static_cast<unsigned>(scene::TextureSlot::Emissive);
  material.alpha_cutoff = 0.3f;
  scene::Mesh floor = make_floor(0.0f, 2.0f);
  for (const glm::vec2& uv : floor.uvs) floor.second_uvs.push_back(glm::vec2(3 * uv.y, 2 * uv.x));
  for (glm::vec2& uv : floor.uvs) uv = 5.0f * uv - 1.3f;
  floor.colors = {{1, 0.5f, 0.5f, 1}, {0.5f, 1, 0.5f, 1}, {0.5f, 0.5f, 1, 1}, {1, 1, 1, 0.6f}};
  scene::complete_tangents(floor, false);
  add_object(scene, floor, material, scene::Role::Virtual, world_from_mesh);
  return scene;
}

common::ImageRgb32f trace_mixed(const scene::Scene& scene, const RenderView& view) {
  trace::EmbreeScene embree(scene);
  embree.place(view.scene);
  const trace::TraceRequest request{.scene = embree,
                                    .lights = view.lights,
                                    .camera = view.ideal,
                                    .camera_from_world = view.scene.camera_from_world,
                                    .settings = {},
                                    .keep_images = true};
  return trace::trace(request).images->mixed;
}

// Pixels that differ by more than rounding. Where an alpha lies at its cut-off to within rounding,
// the two may see a hole or none.
int wrong_pixels(const glm::mat4& world_from_mesh) {
  const scene::Scene scene = everything_scene(world_from_mesh);
  const RenderView view =
      make_view(scene, make_pinhole(96, 72, 90.0), look_at({0.3, 0.35, 1.7}, {0.0, 0.0, 0.2}),
                {make_sun(glm::normalize(glm::vec3(0.3f, 1.0f, 0.2f)))});
  RasterRig rig(scene);
  const RasterFrame frame = rig.render(view);
  const common::ImageRgb32f traced = trace_mixed(scene, view);
  int wrong = 0, seen = 0;
  for (int y = 0; y < 72; ++y) {
    for (int x = 0; x < 96; ++x) {
      const glm::vec3 a(frame.mixed->at(x, y)), b(traced.at(x, y));
      if (b != glm::vec3(0.0f)) ++seen;
      for (int i = 0; i < 3; ++i) {
        if (std::abs(a[i] - b[i]) > 2e-3f * std::max(1.0f, b[i])) {
          ++wrong;
          break;
        }
      }
    }
  }
  EXPECT_GT(seen, 96 * 72 / 4);
  return wrong;
}

TEST(MaterialParity, EveryKindOfTextureIsTheSameInBothRenderers) {
  EXPECT_LE(wrong_pixels(glm::mat4(1.0f)), 6);
}

TEST(MaterialParity, AlsoMirroredAndStretched) {
  EXPECT_LE(wrong_pixels(glm::scale(glm::mat4(1.0f), {-1.0f, 2.0f, 0.7f})), 6);
  EXPECT_LE(wrong_pixels(glm::scale(glm::mat4(1.0f), {0.5f, -1.0f, 0.9f})), 6);
}

}  // namespace
}  // namespace amalgam::passes
