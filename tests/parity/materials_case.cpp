#include "parity/materials_case.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "scene/mesh_tangents.h"
#include "scene/mip_chain.h"
#include "support/scene_builders.h"

namespace amalgam::parity {
namespace {

using scene::Role;
using scene::TextureSlot;
using namespace test_support;

std::uint8_t byte(double value) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

// texel(u, v) gives RGBA in [0, 1]; soft enough that its size shows the levels, not the texels.
template <typename Texel>
std::uint32_t add_texture(scene::Scene& scene, glm::ivec2 size, scene::TexelEncoding encoding,
                          const Texel& texel) {
  scene::Texture texture;
  texture.texels = common::ImageRgba8(size.x, size.y);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const glm::dvec4 value = texel((x + 0.5) / size.x, (y + 0.5) / size.y);
      texture.texels.at(x, y) = {byte(value.r), byte(value.g), byte(value.b), byte(value.a)};
    }
  }
  texture.mips = scene::make_mips(texture.texels, encoding);
  scene.textures.push_back(std::move(texture));
  return static_cast<std::uint32_t>(scene.textures.size() - 1);
}

double wave(double u, double periods) {
  return 0.5 + 0.5 * std::sin(2.0 * reference::kPi * periods * u);
}

struct Textures {
  std::uint32_t stripes, dents, metal, glow, frost, holes;
};

Textures add_textures(scene::Scene& scene) {
  using glm::dvec4;
  using scene::TexelEncoding;
  return {
      .stripes = add_texture(
          scene, {64, 48}, TexelEncoding::Srgb,
          [](double u, double v) { return dvec4(wave(u, 8), 0.3 + 0.6 * v, wave(u + v, 5), 1.0); }),
      .dents = add_texture(scene, {32, 32}, TexelEncoding::Linear,
                           [](double u, double v) {
                             return dvec4(0.35 + 0.3 * wave(u, 2), 0.4 + 0.2 * wave(v, 3), 0.95, 1);
                           }),
      .metal = add_texture(
          scene, {16, 64}, TexelEncoding::Linear,
          [](double u, double v) { return dvec4(0.0, 0.4 + 0.6 * wave(v, 4), wave(u, 2), 1.0); }),
      .glow =
          add_texture(scene, {33, 17}, TexelEncoding::Srgb,
                      [](double u, double v) { return dvec4(wave(u, 3), wave(v, 2), 0.2, 1.0); }),
      .frost = add_texture(scene, {24, 24}, TexelEncoding::Linear,
                           [](double u, double v) {
                             return dvec4(0.2 + 0.8 * wave(u, 2) * wave(v, 2), 0.0, 0.0, 1.0);
                           }),
      .holes = add_texture(scene, {32, 32}, TexelEncoding::Srgb,
                           [](double u, double v) {
                             return dvec4(0.4, 0.8, 0.3, wave(u, 2) * 0.5 + wave(v, 2) * 0.5);
                           }),
  };
}

scene::Mesh with_uvs_times(scene::Mesh mesh, float factor) {
  for (glm::vec2& uv : mesh.uvs) uv *= factor;
  return mesh;
}

scene::Mesh with_tangents(scene::Mesh mesh) {
  scene::complete_tangents(mesh, false);
  return mesh;
}

void add_diffuse_objects(scene::Scene& scene, const Textures& textures) {
  scene::Mesh floor = with_tangents(with_uvs_times(make_floor(0.0f, 0.4f), 6.0f));
  floor.colors = {{1, 0.9f, 0.8f, 1}, {0.6f, 0.8f, 1, 1}, {0.9f, 0.9f, 0.5f, 1}, {1, 1, 1, 1}};
  scene::Material tiles = make_diffuse({0.8f, 0.75f, 0.7f}, 0.7f);
  tiles.base_color_texture = textures.stripes;
  tiles.normal_texture = textures.dents;
  tiles.normal_scale = 0.6f;
  add_object(scene, std::move(floor), tiles, Role::Real);

  scene::Material plate = make_diffuse({0.9f, 0.7f, 0.5f}, 0.9f);
  plate.metallic = 1.0f;
  plate.metallic_roughness_texture = textures.metal;
  add_object(scene, make_box({-0.09f, 0.001f, -0.02f}, {-0.05f, 0.03f, 0.02f}), plate,
             Role::Virtual);

  // Mirrored and stretched; its picture lies on the second coordinates.
  scene::Mesh ball = with_tangents(make_sphere({0.0f, 0.0f, 0.0f}, 0.02f, 24, 12));
  for (const glm::vec2& uv : ball.uvs) ball.second_uvs.emplace_back(2.0f * uv.y, uv.x);
  scene::Material dented = make_diffuse({0.9f, 0.9f, 0.9f}, 0.6f);
  dented.base_color_texture = textures.stripes;
  dented.second_uv_slots = 1u << static_cast<unsigned>(TextureSlot::BaseColor);
  dented.normal_texture = textures.dents;
  add_object(
      scene, std::move(ball), dented, Role::Virtual,
      glm::scale(glm::translate(glm::mat4(1.0f), {-0.02f, 0.026f, 0.03f}), {-1.0f, 1.2f, 0.7f}));

  scene::Material sign = make_diffuse(glm::vec3(0.1f));
  sign.emission = {0.9f, 0.7f, 1.5f};
  sign.emissive_texture = textures.glow;
  add_object(scene, make_quad({0.09f, 0.03f, -0.1f}, {0.03f, 0.0f, 0.0f}, {0.0f, 0.025f, -0.005f}),
             sign, Role::Virtual);
  scene::Material lace = make_diffuse(glm::vec3(1.0f), 0.8f);
  lace.base_color_texture = textures.holes;
  lace.alpha_cutoff = 0.5f;
  add_object(scene, make_quad({0.1f, 0.035f, -0.02f}, {0.025f, 0.0f, 0.0f}, {0.0f, 0.03f, 0.005f}),
             lace, Role::Real);
}

void add_specular_objects(scene::Scene& scene, const Textures& textures) {
  scene::Material mirror = make_mirror(glm::vec3(0.95f));
  mirror.base_color_texture = textures.stripes;
  mirror.normal_texture = textures.dents;
  mirror.normal_scale = 0.05f;
  add_object(scene,
             with_tangents(make_quad({-0.03f, 0.045f, -0.14f}, {0.07f, 0.0f, 0.015f},
                                     {0.0f, 0.045f, -0.01f})),
             mirror, Role::Virtual);

  scene::Material frosted = make_glass(1.5f);
  frosted.thin = true;
  frosted.base_color = {0.9f, 0.95f, 1.0f, 1.0f};
  frosted.transmission_texture = textures.frost;
  add_object(scene, make_quad({0.04f, 0.035f, 0.0f}, {0.03f, 0.0f, 0.01f}, {0.0f, 0.03f, 0.004f}),
             frosted, Role::Virtual);
  frosted.transmission = 0.7f;
  add_object(scene, make_quad({-0.1f, 0.03f, 0.05f}, {0.02f, 0.0f, -0.01f}, {0.0f, 0.025f, 0.0f}),
             frosted, Role::Real);

  // Opaque in parts. Roughness counts there: all over the block (0.24 to 0.6), here and there on
  // the sheet (0.14 to 0.35).
  scene::Material etched = make_glass(1.5f, {4.0f, 2.0f, 1.0f});
  etched.base_color = {0.95f, 0.8f, 0.6f, 1.0f};
  etched.transmission_texture = textures.frost;
  etched.metallic = 0.5f;
  etched.roughness = 0.6f;
  etched.metallic_roughness_texture = textures.metal;
  add_object(scene, make_box({-0.085f, 0.035f, -0.09f}, {-0.055f, 0.07f, -0.075f}), etched,
             Role::Virtual);
  etched.thin = true;
  etched.transmission = 0.8f;
  etched.roughness = 0.35f;
  add_object(scene, make_quad({0.05f, 0.015f, 0.07f}, {0.025f, 0.0f, -0.005f}, {0.0f, 0.02f, 0.0f}),
             etched, Role::Real);

  scene::Material milky = make_glass(1.4f, {3.0f, 1.0f, 2.0f});
  milky.transmission = 0.6f;
  milky.normal_texture = textures.dents;
  milky.normal_scale = 0.1f;
  add_object(scene, with_tangents(make_sphere({0.02f, 0.022f, -0.06f}, 0.02f, 32, 16)), milky,
             Role::Virtual);
}

}  // namespace

ParityCase make_materials_case() {
  ParityCase result;
  result.name = "materials";
  scene::Scene& scene = result.scene;
  scene.world.marker = 40;
  const Textures textures = add_textures(scene);
  add_diffuse_objects(scene, textures);
  add_specular_objects(scene, textures);

  scene.environment = scene::Environment{common::ImageRgb32f(16, 8), false};
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      const float u = static_cast<float>(wave(x / 16.0, 1.0));
      scene.environment->radiance.at(x, y) = {0.2f + 0.4f * u, 0.7f - 0.06f * static_cast<float>(y),
                                              0.5f - 0.2f * u};
    }
  }
  scene::PunctualLight lamp;
  lamp.kind = scene::PunctualLight::Kind::Point;
  lamp.intensity = {0.06f, 0.05f, 0.04f};
  lamp.anchor_from_light = glm::translate(glm::mat4(1.0f), {0.12f, 0.25f, 0.1f});
  scene.punctual_lights.push_back(lamp);

  result.camera = make_pinhole(160, 120, 170.0);
  place_camera(result);
  return result;
}

}  // namespace amalgam::parity
