#include "support/reference/media_around.h"

#include <cmath>
#include <map>
#include <vector>

namespace amalgam::reference {
namespace {

// Seen from the point, over 4 pi; positive if it sees the inner side (van Oosterom and Strackee,
// "The Solid Angle of a Plane Triangle", 1983).
double share_of_sphere(const Triangle& triangle, const Vec3& point) {
  const Vec3 a = triangle.corners[0] - point, b = triangle.corners[1] - point,
             c = triangle.corners[2] - point;
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  const double volume = glm::dot(a, glm::cross(b, c));
  const double rest =
      la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  const double share = 2.0 * std::atan2(std::abs(volume), rest) / (4.0 * kPi);
  return glm::dot(triangle.geometric_normal, a) > 0.0 ? share : -share;
}

struct Surroundings {
  const Object* medium = nullptr;
  double winding = 0.0;
  double way_out = kInfinity;  // metres, along one direction
};

bool is_solid(const Object& object) {
  return object.material.kind == scene::MaterialKind::Dielectric && !object.material.thin;
}

std::map<std::uint32_t, Surroundings> wind_around(const Geometry& geometry, const Vec3& point) {
  std::map<std::uint32_t, Surroundings> media;
  const auto add = [&](std::uint32_t index, double winding) {
    const Object& object = geometry.objects[index];
    if (!is_solid(object)) return;
    Surroundings& medium = media[object.medium];
    medium.medium = &object;
    medium.winding += winding;
  };
  for (const Triangle& triangle : geometry.triangles) {
    add(triangle.object, share_of_sphere(triangle, point));
  }
  for (const Ball& ball : geometry.balls) {
    add(ball.object, glm::distance(ball.centre, point) < ball.radius ? 1.0 : 0.0);
  }
  return media;
}

}  // namespace

MediaStack media_around(const World& world, const Vec3& point) {
  auto media = wind_around(world.geometry(), point);
  // Of media within each other the inner one ends first, whichever way.
  const Ray ray{.origin = point, .direction = glm::normalize(Vec3(0.3, 0.8, 0.52))};
  world.for_each_hit(ray, [&](const Hit& hit) {
    const Object& object = world.object(hit);
    if (is_solid(object) && !is_front(ray, hit)) {
      double& way_out = media[object.medium].way_out;
      way_out = std::min(way_out, hit.t);
    }
    return true;
  });
  std::vector<Surroundings> around;
  for (const auto& [number, medium] : media) {
    if (medium.winding > 0.5) around.push_back(medium);
  }
  std::sort(around.begin(), around.end(),
            [](const Surroundings& a, const Surroundings& b) { return a.way_out > b.way_out; });
  MediaStack stack;
  for (const Surroundings& medium : around) stack = stack.entered(*medium.medium);
  return stack;
}

}  // namespace amalgam::reference
