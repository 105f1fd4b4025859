// Textures and vertex colors: each against the radiance that one point of a floor must have.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "parity/closed_form_rig.h"
#include "support/reference/color_curves.h"

namespace amalgam::reference {
namespace {

using scene::Role;
using scene::TextureSlot;
using test_support::make_diffuse;
using test_support::make_floor;
using test_support::make_glass;
using test_support::make_quad;
using test_support::make_sun;

const Vec3 kEye(0.1, 2.0, 0.23);
const Vec3 kDown(0.0, -1.0, 0.0);

// Roughness 1 scatters the specular part as evenly as the diffuse one.
Color radiance_of_rough(const Color& base_color, double irradiance) {
  return irradiance / kPi * (0.96 * base_color + 0.04);
}

ClosedFormRig floor_under_sun(const scene::Material& material) {
  ClosedFormRig rig;
  rig.add(make_floor(0.0f, 1.0f), material);
  rig.lights.push_back(make_sun({0.0f, 1.0f, 0.0f}));
  return rig;
}

TEST(ReferenceMaterial, VertexColorsMeetAtTheBarycentre) {
  ClosedFormRig rig = floor_under_sun(make_diffuse({0.5f, 1.0f, 1.0f}));
  scene::Mesh& mesh = rig.scene.meshes[0];
  mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0.5f, 1, 1}, {1, 1, 1, 1}};
  const glm::uvec3 corners = mesh.triangles[0];  // 0, 1, 2
  const Vec3 barycentre =
      Vec3(mesh.positions[corners.x] + mesh.positions[corners.y] + mesh.positions[corners.z]) / 3.0;
  const Color seen = rig.trace(barycentre - kDown, kDown).mixed;
  EXPECT_LT(glm::length(seen - radiance_of_rough({0.5 / 3.0, 0.5, 1.0 / 3.0}, 3.0)), 1e-7);
}

TEST(ReferenceMaterial, BaseColorTimesTextureDecoded) {
  scene::Material material = make_diffuse({0.5f, 1.0f, 0.25f});
  material.base_color_texture = 0;
  ClosedFormRig rig = floor_under_sun(material);
  add_texture(rig.scene, {188, 55, 255, 255});
  const Color texel(srgb_decode(188.0 / 255.0), srgb_decode(55.0 / 255.0), 1.0);
  const Color expected = radiance_of_rough(Color(0.5, 1.0, 0.25) * texel, 3.0);
  EXPECT_LT(glm::length(rig.trace(kEye, kDown).mixed - expected), 1e-12);
}

TEST(ReferenceMaterial, TextureMayHaveCoordinatesOfItsOwn) {
  scene::Material material = make_diffuse(glm::vec3(1.0f));
  material.base_color_texture = 0;
  ClosedFormRig rig = floor_under_sun(material);
  add_texture(rig.scene, {255, 255, 255, 255});
  rig.scene.textures[0].texels = common::ImageRgba8(2, 1, {0, 0, 0, 255});
  rig.scene.textures[0].texels.at(1, 0) = {255, 255, 255, 255};
  scene::Mesh& mesh = rig.scene.meshes[0];
  mesh.uvs.assign(4, {0.25f, 0.5f});         // black
  mesh.second_uvs.assign(4, {0.75f, 0.5f});  // white
  EXPECT_NEAR(rig.trace(kEye, kDown).mixed.g, radiance_of_rough(Color(0.0), 3.0).g, 1e-12);
  rig.scene.materials[0].second_uv_slots = 1u << static_cast<unsigned>(TextureSlot::BaseColor);
  EXPECT_NEAR(rig.trace(kEye, kDown).mixed.g, radiance_of_rough(Color(1.0), 3.0).g, 1e-12);
  mesh.second_uvs.clear();  // no place, no texture
  rig.scene.materials[0].base_color = {0.5f, 0.5f, 0.5f, 1.0f};
  EXPECT_NEAR(rig.trace(kEye, kDown).mixed.g, radiance_of_rough(Color(0.5), 3.0).g, 1e-12);
}

TEST(ReferenceMaterial, MetallicIsBlueAndRoughnessGreen) {
  scene::Material material = make_diffuse({0.75f, 0.5f, 0.25f}, 0.5f);
  material.metallic = 0.5f;
  material.metallic_roughness_texture = 0;
  ClosedFormRig rig = floor_under_sun(material);
  add_texture(rig.scene, {7, 204, 102, 255});
  const double metallic = 0.5 * 0.4, roughness = 0.5 * 0.8;  // 102 and 204 of 255
  const double exponent = 0.5 / std::pow(roughness, 4.0) - 0.5;
  const Color base(0.75, 0.5, 0.25);
  const Color specular = glm::mix(Color(0.04), base, metallic);
  // Light and viewer above: the lobe is 1.
  const Color expected =
      3.0 * ((1.0 - metallic) * 0.96 * base / kPi + specular * ((exponent + 2.0) / (2.0 * kPi)));
  EXPECT_LT(glm::length(rig.trace(kEye, kDown).mixed - expected), 1e-12);
}

TEST(ReferenceMaterial, EmissionTimesTextureDecoded) {
  scene::Material material = make_lamp({4.0f, 2.0f, 1.0f});
  material.emissive_texture = 0;
  ClosedFormRig rig;
  rig.add(make_floor(0.0f, 1.0f), material);
  add_texture(rig.scene, {188, 255, 0, 255});
  const Color expected(4.0 * srgb_decode(188.0 / 255.0), 2.0, 0.0);
  EXPECT_LT(glm::length(rig.trace(kEye, kDown).mixed - expected), 1e-12);
}

// The tilted normal's cosine towards a slanted sun. The floor's texture has +x along +X and +y
// (against v) along -Z; a mirrored instance turns +x around and neither +y nor the outer side.
TEST(ReferenceMaterial, NormalTextureTiltsAFlatFloor) {
  for (const double mirrored : {1.0, -1.0}) {
    for (const double handedness : {1.0, -1.0}) {
      scene::Material material = make_diffuse(glm::vec3(1.0f));
      material.normal_texture = 0;
      material.normal_scale = 0.5f;
      ClosedFormRig rig;
      add_texture(rig.scene, {229, 51, 204, 255});  // 2 c / 255 - 1
      scene::Mesh floor = make_floor(0.0f, 1.0f);
      floor.tangents.assign(4, {1.0f, 0.0f, 0.0f, static_cast<float>(handedness)});
      rig.add(floor, material).anchor_from_mesh =
          glm::scale(glm::mat4(1.0f), {static_cast<float>(mirrored), 1.0f, 1.0f});
      rig.lights.push_back(make_sun({0.25f, 0.75f, 0.5f}));

      const double x = 0.5 * (2.0 * 229.0 / 255.0 - 1.0), y = 0.5 * (0.4 - 1.0), z = 0.6;
      const Vec3 normal = glm::normalize(Vec3(mirrored * x, z, -handedness * y));
      const double cosine = glm::dot(normal, glm::normalize(Vec3(0.25, 0.75, 0.5)));
      const Color expected = radiance_of_rough(Color(1.0), 3.0 * cosine);
      EXPECT_LT(glm::length(rig.trace(kEye, kDown).mixed - expected), 1e-6)
          << mirrored << " " << handedness;
    }
  }
}

TEST(ReferenceMaterial, NormalTextureTurnsAMirror) {
  scene::Material material = test_support::make_mirror();
  material.normal_texture = 0;
  ClosedFormRig rig;
  add_texture(rig.scene, {204, 127, 229, 255});
  scene::Mesh floor = make_floor(0.0f, 1.0f);
  floor.tangents.assign(4, {1.0f, 0.0f, 0.0f, 1.0f});
  rig.add(std::move(floor), material);
  // What is reflected: a lamp whose place is in its color.
  const Vec3 normal = glm::normalize(Vec3(0.6, 2.0 * 229.0 / 255.0 - 1.0, 1.0 / 255.0));
  const Vec3 reflected = reflect(kDown, normal);
  const Vec3 lamp = Vec3(kEye.x, 0.0, kEye.z) + 3.0 * reflected;
  rig.add(make_quad(glm::vec3(lamp), {0.0f, 0.0f, 0.001f}, {0.001f, 0.001f, 0.0f}), make_lamp());
  EXPECT_NEAR(rig.trace(kEye, kDown).mixed.g, 1.0, 1e-12);
}

// What a sheet does not reflect: half goes through to the lamp below, half comes back.
TEST(ReferenceMaterial, HalfTransmissionIsHalfAndHalf) {
  for (const bool thin : {true, false}) {
    for (const Role role : {Role::Virtual, Role::Real}) {
      scene::Material sheet = make_glass(1.5f);
      sheet.base_color = {0.5f, 1.0f, 0.75f, 1.0f};
      sheet.thin = thin;
      sheet.transmission_texture = 0;
      sheet.transmission = 0.625f;
      ClosedFormRig rig;
      add_texture(rig.scene, {204, 0, 0, 0});  // 0.8
      rig.add(make_floor(0.0f, 1.0f), sheet, role);
      scene::Material lamp = make_lamp(glm::vec3(2.0f));
      lamp.metallic = 1.0f;  // and black: sends nothing of the sun back
      rig.add(make_floor(-1.0f, 1.0f), lamp, Role::Virtual);
      rig.lights.push_back(make_sun({0.0f, 1.0f, 0.0f}));
      const double reflected = thin ? 2.0 * 0.04 / 1.04 : 0.04;
      const Color tint(0.5, 1.0, 0.75);
      const Color back = (1.0 - reflected) * 0.5 * tint * 3.0 / kPi;
      // Not thin, it is the surface of glass, and the lamp lies in it.
      const double lamp_seen = thin ? 2.0 : 2.0 / (1.5 * 1.5);
      const Color through = (1.0 - reflected) * 0.5 * tint * lamp_seen;
      const Sample sample = rig.trace(kEye, kDown);
      EXPECT_LT(glm::length(sample.mixed - (through + back)), 1e-12);
      EXPECT_LT(glm::length(sample.real - (role == Role::Real ? back : Color(0.0))), 1e-12);
    }
  }
}

TEST(ReferenceMaterial, ShadowThroughATransmissionTexture) {
  ClosedFormRig rig = floor_under_sun(make_diffuse(glm::vec3(1.0f)));
  const Color lit = rig.trace({0.9, 1.0, 0.0}, {-0.8, -1.0, 0.0}).mixed;
  scene::Material sheet = make_glass(1.5f);
  sheet.thin = true;
  sheet.transmission_texture = 0;
  sheet.base_color = {0.5f, 1.0f, 0.75f, 1.0f};
  add_texture(rig.scene, {51, 0, 0, 0});  // 0.2
  rig.add(make_quad({0.0f, 2.0f, 0.0f}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.0f, -0.5f}), sheet);
  const Color expected = lit * Color(0.5, 1.0, 0.75) * 0.2 * (1.0 - 2.0 * 0.04 / 1.04);
  const Color seen = rig.trace({0.9, 1.0, 0.0}, {-0.8, -1.0, 0.0}).mixed;
  EXPECT_LT(glm::length(seen - expected), 1e-12);
}

}  // namespace
}  // namespace amalgam::reference
