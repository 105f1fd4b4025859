#include "parity/shadow_edges.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "support/reference/arriving_light.h"
#include "support/reference/lens.h"
#include "support/reference/phong.h"
#include "support/reference/shadow.h"

namespace amalgam::parity {
namespace {

using namespace reference;

// A change of light that counts as an edge: at exposure 1 a byte shows it as 3 in black.
constexpr double kVisible = 1e-3;

// What passes/raster/shadow_layout.h says of layers and sizes.
int layers_of(const scene::Light& light) {
  using Kind = scene::Light::Kind;
  const bool narrow = std::acos(static_cast<double>(light.cos_outer)) <= 1.05;
  return light.kind == Kind::Directional || (light.kind == Kind::Spot && narrow) ? 1 : 6;
}

int map_side(const std::vector<scene::Light>& lights) {
  int layers = 0;
  for (const scene::Light& light : lights) layers += layers_of(light);
  if (layers <= 8) return 2048;
  if (layers <= 32) return 1024;
  return layers <= 128 ? 512 : 256;
}

bool is_flat(const scene::Mesh& mesh) {
  Box box;
  for (const glm::vec3& p : mesh.positions) box.include(Vec3(p));
  const Vec3 size = box.high - box.low;
  return std::min({size.x, size.y, size.z}) == 0.0;
}

// Of all that may shadow itself. In these scenes nothing lies beside it that could shadow another
// thing: what is flat is one table below it.
std::vector<Vec3> corners_of_boxes(const scene::Scene& scene,
                                   const scene::AnchoredScene& anchored) {
  std::vector<Vec3> corners;
  for (const scene::AnchoredInstance& placed : anchored.instances) {
    const scene::Mesh& mesh = scene.meshes[scene.instances[placed.instance].mesh];
    if (is_flat(mesh)) continue;
    Box box;
    for (const glm::vec3& p : mesh.positions) box.include(Vec3(p));
    for (int i = 0; i < 8; ++i) {
      const Vec3 corner((i & 1) != 0 ? box.high.x : box.low.x,
                        (i & 2) != 0 ? box.high.y : box.low.y,
                        (i & 4) != 0 ? box.high.z : box.low.z);
      corners.push_back(transform_point(glm::dmat4(placed.world_from_mesh), corner));
    }
  }
  return corners;
}

Vec3 any_perpendicular(const Vec3& direction) {
  const Vec3 helper = std::abs(direction.y) < 0.9 ? Vec3(0.0, 1.0, 0.0) : Vec3(1.0, 0.0, 0.0);
  return glm::normalize(glm::cross(direction, helper));
}

}  // namespace

ShadowEdges::ShadowEdges(const ParityCase& parity_case)
    : case_(parity_case),
      request_(make_reference_request(parity_case)),
      world_(make_geometry(parity_case.scene, request_.anchored), parity_case.scene.textures),
      extent_(corners_of_boxes(parity_case.scene, request_.anchored)),
      map_side_(map_side(request_.lights)) {}

// Of a parallel light: its map covers all that may shadow itself, however it is turned about the
// light.
double ShadowEdges::texel(const scene::Light& light, const Vec3& point) const {
  if (light.kind == scene::Light::Kind::Point || layers_of(light) == 6) {
    return 2.0 * glm::distance(Vec3(light.position), point) / map_side_;
  }
  if (light.kind == scene::Light::Kind::Spot) {
    const double half_angle = std::acos(static_cast<double>(light.cos_outer));
    return 2.0 * std::tan(half_angle) * glm::distance(Vec3(light.position), point) / map_side_;
  }
  const Vec3 axis = glm::normalize(Vec3(light.to_light));
  double widest = 0.0;
  for (const Vec3& a : extent_) {
    for (const Vec3& b : extent_) {
      widest = std::max(widest, glm::length(glm::cross(a - b, axis)));
    }
  }
  return 1.03 * widest / map_side_;
}

// What a primary ray met, from its side.
struct ShadowEdges::Seen {
  Vec3 position, geometric_normal, shading_normal, to_viewer;
  Phong phong;
};

ShadowEdges::Surroundings ShadowEdges::around(int x, int y, double reach) const {
  const glm::dmat4 world_from_camera = glm::inverse(request_.anchored.camera_from_world);
  const Vec3 direction =
      glm::normalize(glm::dmat3(world_from_camera) * pinhole_direction(case_.camera, Vec2(x, y)));
  const auto hit = world_.closest({.origin = Vec3(world_from_camera[3]),
                                   .direction = direction,
                                   .spread = 1.0 / case_.camera.fy});
  Surroundings result;
  if (!hit) return result;
  const SurfaceMaterial material = world_.material(*hit);
  const double side = glm::dot(hit->geometric_normal, direction) < 0.0 ? 1.0 : -1.0;
  const Seen seen{hit->position, side * hit->geometric_normal, side * material.normal, -direction,
                  phong_of(Color(material.base_color), material.metallic, material.roughness)};
  for (const scene::Light& light : request_.lights) look_around(light, seen, reach, result);
  return result;
}

// At points of the surface's plane that lie on circles as the light sees them.
void ShadowEdges::look_around(const scene::Light& light, const Seen& seen, double reach,
                              Surroundings& result) const {
  constexpr int kDirections = 32;
  constexpr double kStep = 0.25;  // texels
  const ArrivingLight arrival = arriving_light(light, seen.position);
  const double cosine = glm::dot(seen.geometric_normal, arrival.to_light);
  if (cosine <= 0.0 || glm::dot(seen.shading_normal, arrival.to_light) <= 0.0) return;
  const Color lit = arrival.irradiance *
                    reflected(seen.phong, seen.shading_normal, arrival.to_light, seen.to_viewer);
  Decisions unheeded;
  const Shadow here = cast_shadow_ray(world_, seen.position, arrival, unheeded);
  const Vec3 u = any_perpendicular(arrival.to_light), v = glm::cross(arrival.to_light, u);
  const double size = texel(light, seen.position);
  Color most(0.0);
  for (double radius = kStep; radius <= reach; radius += kStep) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * kPi * i / kDirections;
      const Vec3 across = radius * size * (std::cos(angle) * u + std::sin(angle) * v);
      const Vec3 point = seen.position + across -
                         glm::dot(across, seen.geometric_normal) / cosine * arrival.to_light;
      const Shadow there = cast_shadow_ray(world_, point, arriving_light(light, point), unheeded);
      const Color change =
          lit * glm::max(glm::abs(there.mixed - here.mixed), glm::abs(there.real - here.real));
      most = glm::max(most, change);
      if (largest_channel(change) > kVisible) result.distance = std::min(result.distance, radius);
    }
  }
  result.change += most;
}

}  // namespace amalgam::parity
