#include "extreme/random_case.h"

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <sstream>

#include "extreme/chance.h"
#include "support/scene_builders.h"

namespace amalgam::extreme {
namespace {

using scene::MaterialKind;
using scene::Role;
using namespace test_support;

constexpr int kWidth = 32, kHeight = 24;

// A case under construction. All lengths are shares of size.
struct Builder {
  Chance chance;
  double size;  // metres
  double brightness;
  parity::ParityCase& to;
  std::ostringstream& text;
};

enum class Shape { Box, Sphere, Quad };
constexpr const char* kShapeNames[] = {"box", "sphere", "quad"};

// Within [-1, 1] on each axis.
scene::Mesh unit_mesh(Shape shape) {
  switch (shape) {
    case Shape::Box:
      return make_box(glm::vec3(-1.0f), glm::vec3(1.0f));
    case Shape::Sphere:
      return make_sphere(glm::vec3(0.0f), 1.0f, 16, 8);
    case Shape::Quad:
      break;
  }
  return make_quad(glm::vec3(0.0f), {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f});
}

// Its vertices have the object's size, so that the transform tells nothing of it.
scene::Mesh mesh_of(Shape shape, double metres) {
  scene::Mesh mesh = unit_mesh(shape);
  for (glm::vec3& p : mesh.positions) p *= static_cast<float>(metres);
  return mesh;
}

scene::Material diffuse_material(Chance& chance, double brightness) {
  scene::Material material =
      make_diffuse(chance.color(0.05, 0.9), static_cast<float>(chance.between(0.25, 1.0)));
  if (chance.happens(0.2)) material.metallic = 1.0f;
  if (chance.happens(0.15)) material.emission = chance.color(0.0, 2.0 * brightness);
  return material;
}

scene::Material glass_material(Chance& chance, double metres) {
  scene::Material material =
      make_glass(static_cast<float>(chance.happens(0.1)   ? 1.0
                                    : chance.happens(0.1) ? 1.0001
                                                          : chance.between(1.1, 2.5)));
  material.base_color = glm::vec4(chance.color(0.6, 1.0), 1.0f);
  material.thin = chance.happens(0.4);
  if (chance.happens(0.3)) material.transmission = static_cast<float>(chance.between(0.0, 1.0));
  if (chance.happens(0.2)) material.roughness = static_cast<float>(chance.between(0.0, 0.6));
  if (!material.thin && chance.happens(0.5)) {
    material.absorption = chance.color(0.0, 2.0) / static_cast<float>(metres);
  }
  return material;
}

scene::Material any_material(Builder& b, double metres) {
  switch (b.chance.integer(0, 3)) {
    case 0:
      return diffuse_material(b.chance, b.brightness);
    case 1: {
      scene::Material mirror = make_mirror(b.chance.color(0.3, 1.0));
      if (b.chance.happens(0.15)) mirror.emission = b.chance.color(0.0, 0.5 * b.brightness);
      return mirror;
    }
    default:
      return glass_material(b.chance, metres);
  }
}

const char* name_of(const scene::Material& material) {
  if (material.kind == MaterialKind::Mirror) return "mirror";
  if (material.kind == MaterialKind::Diffuse) return "diffuse";
  return material.thin ? "thin glass" : "solid glass";
}

void add(Builder& b, Shape shape, double metres, const scene::Material& material, Role role,
         const glm::dmat4& place) {
  const glm::dvec3 at(place[3]);
  b.text << "\n  " << (role == Role::Real ? "real " : "virtual ") << name_of(material);
  if (material.kind == MaterialKind::Dielectric) {
    b.text << " n " << material.ior << " transmission " << material.transmission << " roughness "
           << material.roughness << " absorption " << material.absorption.g;
  }
  b.text << ' ' << kShapeNames[static_cast<int>(shape)] << " of " << metres << " m at (" << at.x
         << ' ' << at.y << ' ' << at.z << ')';
  add_object(b.to.scene, mesh_of(shape, metres), material, role, glm::mat4(place));
}

Role any_role(Chance& chance) {
  return chance.happens(0.5) ? Role::Real : Role::Virtual;
}

// Turned, and at times stretched or mirrored.
glm::dmat4 any_place(Chance& chance, const glm::dvec3& at) {
  glm::dmat4 place = glm::translate(glm::dmat4(1.0), at);
  const double angle = chance.between(0.0, 2.0 * std::numbers::pi);
  place = glm::rotate(place, angle, chance.direction());
  if (chance.happens(0.3)) {
    glm::dvec3 stretch;
    for (int axis = 0; axis < 3; ++axis) stretch[axis] = chance.decades(0.3, 2.0);
    place = glm::scale(place, stretch);
  }
  return chance.happens(0.15) ? glm::scale(place, glm::dvec3(-1.0, 1.0, 1.0)) : place;
}

void add_any_object(Builder& b) {
  const double metres = b.size * b.chance.decades(0.03, 0.5);
  const scene::Material material = any_material(b, metres);
  // What is solid has an inside.
  const bool solid = material.kind == MaterialKind::Dielectric && !material.thin;
  const auto shape = static_cast<Shape>(b.chance.integer(0, solid ? 1 : 2));
  const glm::dvec3 at = b.size * (b.chance.in_box(0.7) + glm::dvec3(0.0, 0.6, 0.0));
  add(b, shape, metres, material, any_role(b.chance), any_place(b.chance, at));
}

// Two to four balls, each in the one before.
void add_nested_glass(Builder& b, const glm::dvec3& middle, double metres) {
  glm::dvec3 at = middle;
  for (int i = b.chance.integer(2, 4); i > 0; --i) {
    scene::Material material = glass_material(b.chance, metres);
    material.thin = false;
    add(b, Shape::Sphere, metres, material, any_role(b.chance),
        glm::translate(glm::dmat4(1.0), at));
    const double inner = metres * b.chance.between(0.3, 0.7);
    at += b.chance.direction() * (0.8 * (0.9 * metres - inner));
    metres = inner;
  }
}

void add_environment(Builder& b) {
  const bool low = b.chance.happens(0.2);
  scene::Environment environment{common::ImageRgb32f(8, 4), low};
  for (glm::vec3& texel : environment.radiance.pixels()) {
    texel = b.chance.color(0.0, low ? 1.0 : b.brightness);
  }
  b.text << "\n  environment" << (low ? ", low dynamic range" : "");
  b.to.scene.environment = std::move(environment);
}

void add_lamp(Builder& b) {
  using Kind = scene::PunctualLight::Kind;
  scene::PunctualLight lamp;
  lamp.kind = static_cast<Kind>(b.chance.integer(0, 2));
  const double strength = b.brightness * (lamp.kind == Kind::Directional ? 1.0 : b.size * b.size);
  lamp.intensity = b.chance.color(0.2 * strength, strength);
  const glm::dvec3 eye = b.size * (b.chance.in_box(0.8) + glm::dvec3(0.0, 1.2, 0.0));
  const glm::dvec3 target = b.size * b.chance.in_box(0.2);
  // A lamp shines along its -Z; a camera's z points forward and its y down.
  glm::dmat4 camera_from_lamp(1.0);
  camera_from_lamp[1][1] = camera_from_lamp[2][2] = -1.0;
  lamp.anchor_from_light =
      glm::mat4(common::rigid_inverse(look_at(eye, target)) * camera_from_lamp);
  if (b.chance.happens(0.3)) lamp.range = static_cast<float>(b.size * b.chance.between(1.0, 4.0));
  const double outer = b.chance.between(0.1, 1.4);
  lamp.cos_outer = static_cast<float>(std::cos(outer));
  lamp.cos_inner = static_cast<float>(std::cos(outer * b.chance.between(0.2, 0.95)));
  constexpr const char* kNames[] = {"directional", "point", "spot"};
  b.text << "\n  " << kNames[static_cast<int>(lamp.kind)] << " lamp at (" << eye.x << ' ' << eye.y
         << ' ' << eye.z << ')';
  b.to.scene.punctual_lights.push_back(lamp);
}

// From a degree to 170, at times with its axis outside the image.
void choose_camera(Builder& b) {
  const double degrees = b.chance.happens(0.1)   ? 1.0
                         : b.chance.happens(0.1) ? 170.0
                                                 : b.chance.between(20.0, 100.0);
  common::CameraModel& camera = b.to.camera;
  camera =
      make_pinhole(kWidth, kHeight, 0.5 * kWidth / std::tan(degrees * std::numbers::pi / 360.0));
  if (b.chance.happens(0.2)) camera.fy *= b.chance.between(0.8, 2.0);
  if (b.chance.happens(0.15)) {
    camera.cx += b.chance.between(-2.0, 2.0) * kWidth;
    camera.cy += b.chance.between(-2.0, 2.0) * kHeight;
  }
  b.to.camera_image = parity::make_camera_image(kWidth, kHeight);
  b.text << "\n  camera " << degrees << " degrees wide, axis at (" << camera.cx << ' ' << camera.cy
         << ')';
}

glm::dvec3 choose_pose(Builder& b) {
  const glm::dvec3 eye = b.size * (b.chance.in_box(1.2) + glm::dvec3(0.0, 1.3, 0.6));
  const glm::dvec3 target = b.size * (b.chance.in_box(0.3) + glm::dvec3(0.0, 0.3, 0.0));
  b.to.poses = {make_pose(b.to.scene.world.marker, look_at(eye, target))};
  b.text << " at (" << eye.x << ' ' << eye.y << ' ' << eye.z << ')';
  return eye;
}

}  // namespace

RandomCase make_random_case(std::uint64_t seed) {
  RandomCase result;
  Chance chance(seed);
  std::ostringstream text;
  const double size = chance.decades(1e-3, 250.0), brightness = chance.decades(0.1, 10.0);
  Builder b{chance, size, brightness, result.parity_case, text};
  b.to.name = "random " + std::to_string(seed);
  b.to.scene.world.marker = 40;
  b.to.exposure = static_cast<float>(1.0 / brightness);
  text << "seed " << seed << ": " << size << " m, brightness " << brightness;
  choose_camera(b);
  const glm::dvec3 eye = choose_pose(b);
  if (b.chance.happens(0.85)) {
    add_object(b.to.scene, make_floor(0.0f, static_cast<float>(2.0 * size)),
               make_diffuse(b.chance.color(0.1, 0.9), 0.9f), Role::Real);
    text << "\n  real floor";
  }
  for (int i = b.chance.integer(1, 6); i > 0; --i) add_any_object(b);
  if (b.chance.happens(0.3)) {
    add_nested_glass(b, size * (b.chance.in_box(0.4) + glm::dvec3(0.0, 0.6, 0.0)),
                     size * b.chance.between(0.1, 0.5));
  }
  if (b.chance.happens(0.12)) add_nested_glass(b, eye, size * b.chance.between(0.1, 0.5));
  if (b.chance.happens(0.85)) add_environment(b);
  for (int i = b.chance.integer(0, 2); i > 0; --i) add_lamp(b);
  result.text = text.str();
  return result;
}

}  // namespace amalgam::extreme
