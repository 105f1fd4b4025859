#include "support/reference/camera_lookup.h"

#include "support/reference/color_curves.h"
#include "support/reference/lens.h"
#include "support/reference/pictures.h"

namespace amalgam::reference {
namespace {

// Only real objects hide a point from the camera: it took its picture without the virtual ones.
bool hidden_by_real_object(const World& world, const Ray& to_camera) {
  bool hidden = false;
  world.for_each_hit(to_camera, [&](const Hit& hit) {
    hidden = world.object(hit).role == scene::Role::Real;
    return !hidden;
  });
  return hidden;
}

}  // namespace

double border_trust(const common::CameraModel& camera, const Vec2& pixel) {
  const double inside =
      std::min({pixel.x, pixel.y, camera.width - 1 - pixel.x, camera.height - 1 - pixel.y});
  const double band = 0.04 * std::min(camera.width, camera.height);
  const double t = std::clamp(inside / band, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

LookUp look_up(const World& world, const CameraView& view, const Vec3& point,
               const Vec3& facing_normal) {
  const glm::dmat4 world_from_camera = glm::inverse(view.camera_from_world);
  const Vec3 eye(world_from_camera[3]);
  const Vec3 way = eye - point;
  if (!(glm::dot(way, facing_normal) > 0.0)) return {};
  const auto pixel = lens_project(view.camera, transform_point(view.camera_from_world, point));
  if (!pixel) return {};
  const double trust = border_trust(view.camera, *pixel);
  if (trust == 0.0) return {};
  const double distance = glm::length(way);
  if (hidden_by_real_object(world, ray_from_surface(point, way / distance, distance))) return {};
  return {trust, inverse_tone_map(sample_camera_image(*view.image, *pixel), view.response)};
}

}  // namespace amalgam::reference
