// What the scenes that come with Amalgam do not have, all in one.
#include "parity/everything_case.h"

#include <glm/gtc/matrix_transform.hpp>

#include "support/scene_builders.h"

namespace amalgam::parity {
namespace {

using scene::Role;
using namespace test_support;

scene::Texture make_checker() {
  scene::Texture texture;
  texture.texels = common::ImageRgba8(8, 8);
  texture.wrap_u = scene::Wrap::Mirror;
  texture.wrap_v = scene::Wrap::Clamp;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const bool dark = (x + y) % 2 == 0;
      texture.texels.at(x, y) = {dark ? 60 : 230, 40 + 20 * x, 250 - 25 * y, dark ? 90 : 250};
    }
  }
  return texture;
}

// Soft, so that what is compared is not the map's own texels magnified.
scene::Environment make_low_dynamic_range_map() {
  scene::Environment map{common::ImageRgb32f(16, 8), true};
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      const float u = static_cast<float>(x < 8 ? x : 16 - x) / 8.0f;
      map.radiance.at(x, y) = {0.2f + 0.3f * u, 0.6f - 0.05f * static_cast<float>(y), 0.4f};
    }
  }
  return map;
}

scene::PunctualLight make_lamp_above(scene::PunctualLight::Kind kind, const glm::vec3& at,
                                     const glm::vec3& intensity) {
  scene::PunctualLight light;
  light.kind = kind;
  light.intensity = intensity;
  // Shines along its own -Z: turned down.
  light.anchor_from_light = glm::translate(glm::mat4(1.0f), at) *
                            glm::rotate(glm::mat4(1.0f), glm::radians(-75.0f), {1.0f, 0.1f, 0.0f});
  return light;
}

void add_glass(scene::Scene& scene) {
  // An air bubble in an absorbing ball.
  add_object(scene, make_sphere({-0.05f, 0.04f, -0.05f}, 0.035f, 24, 12),
             make_glass(1.5f, {6.0f, 2.0f, 3.0f}), Role::Virtual);
  add_object(scene, make_sphere({-0.045f, 0.045f, -0.045f}, 0.012f, 16, 8), make_glass(1.0f),
             Role::Virtual);
  // A mirroring transform, tinted; real, so that it shadows both solutions.
  scene::Material tinted = make_glass(1.33f, glm::vec3(1.0f));
  tinted.base_color = {0.9f, 0.7f, 0.95f, 1.0f};
  add_object(
      scene, make_box({0.03f, 0.002f, -0.04f}, {0.07f, 0.05f, -0.015f}), tinted, Role::Real,
      glm::scale(glm::rotate(glm::mat4(1.0f), 0.4f, {0.0f, 1.0f, 0.0f}), {-1.0f, 1.0f, 0.8f}));
  scene::Material pane = make_glass(1.5f, glm::vec3(50.0f));
  pane.thin = true;
  pane.base_color = {0.7f, 0.95f, 0.8f, 1.0f};
  add_object(scene, make_quad({0.02f, 0.04f, 0.03f}, {0.03f, 0.0f, 0.006f}, {0.0f, 0.03f, 0.008f}),
             pane, Role::Virtual);
}

}  // namespace

ParityCase make_everything_case() {
  ParityCase result;
  result.name = "everything";
  scene::Scene& scene = result.scene;
  scene.world.marker = 40;
  scene.textures.push_back(make_checker());
  scene.environment = make_low_dynamic_range_map();
  add_object(scene, make_floor(0.0f, 0.4f), make_diffuse({0.7f, 0.65f, 0.6f}, 0.8f), Role::Real);
  add_glass(scene);
  add_object(scene, make_quad({0.0f, 0.05f, -0.12f}, {0.09f, 0.0f, 0.02f}, {0.0f, 0.05f, -0.01f}),
             make_mirror({0.95f, 0.8f, 0.7f}), Role::Real);
  scene::Material leaf = make_diffuse(glm::vec3(1.0f), 0.5f);
  leaf.base_color_texture = 0;
  leaf.alpha_cutoff = 0.5f;
  scene::Mesh leaf_mesh =
      make_quad({0.07f, 0.04f, -0.07f}, {0.03f, 0.0f, -0.01f}, {0.0f, 0.035f, 0.0f});
  for (glm::vec2& uv : leaf_mesh.uvs) uv = uv * 1.7f - 0.3f;
  add_object(scene, std::move(leaf_mesh), leaf, Role::Virtual);
  scene::Material lamp = make_diffuse({0.2f, 0.2f, 0.2f});
  lamp.emission = {0.8f, 0.3f, 0.1f};
  add_object(scene, make_box({-0.02f, 0.001f, 0.03f}, {0.0f, 0.021f, 0.05f}), lamp, Role::Virtual);
  scene::Material brass = make_diffuse({0.8f, 0.6f, 0.3f}, 0.4f);
  brass.metallic = 1.0f;  // too rough for a mirror
  add_object(scene, make_sphere({0.11f, 0.02f, 0.0f}, 0.018f, 24, 12), brass, Role::Virtual);

  using Kind = scene::PunctualLight::Kind;
  scene.punctual_lights.push_back(make_lamp_above(Kind::Directional, {}, {1.0f, 0.95f, 0.9f}));
  scene.punctual_lights.push_back(
      make_lamp_above(Kind::Point, {-0.1f, 0.2f, 0.1f}, {0.03f, 0.03f, 0.05f}));
  scene.punctual_lights.back().range = 0.5f;
  scene.punctual_lights.push_back(
      make_lamp_above(Kind::Spot, {0.1f, 0.3f, 0.05f}, {0.1f, 0.08f, 0.05f}));
  scene.punctual_lights.back().cos_inner = 0.95f;
  scene.punctual_lights.back().cos_outer = 0.85f;

  result.camera = make_pinhole(160, 120, 170.0);
  place_camera(result);
  result.exposure = 1.3f;
  return result;
}

}  // namespace amalgam::parity
