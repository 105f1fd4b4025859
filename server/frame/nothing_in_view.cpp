#include "frame/nothing_in_view.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

namespace amalgam::frame {
namespace {

using Points = std::vector<glm::dvec3>;

// Pairs of objects and lights. Beyond this the test costs more than it may save.
constexpr std::size_t kMostPairs = 4096;

// The view's four sides and the camera's plane, in the world: a point is outside where
// dot(normal, p) + offset < 0.
struct Plane {
  glm::dvec3 normal{0.0};
  double offset = 0.0;
};
using View = std::array<Plane, 5>;

// A few pixels larger than the picture: shadows are filtered, and samples lie between pixel
// centres.
View view_planes(const passes::RenderView& view) {
  constexpr double kMargin = 3.0;
  const common::CameraModel& camera = view.ideal;
  const double left = (-kMargin - camera.cx) / camera.fx;
  const double right = (camera.width - 1.0 + kMargin - camera.cx) / camera.fx;
  const double top = (-kMargin - camera.cy) / camera.fy;
  const double bottom = (camera.height - 1.0 + kMargin - camera.cy) / camera.fy;
  const std::array<glm::dvec3, 5> in_camera{glm::dvec3(1.0, 0.0, -left),
                                            {-1.0, 0.0, right},
                                            {0.0, 1.0, -top},
                                            {0.0, -1.0, bottom},
                                            {0.0, 0.0, 1.0}};
  View planes;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const glm::dvec4 in_world = glm::dvec4(in_camera[i], 0.0) * view.scene.camera_from_world;
    planes[i] = {glm::dvec3(in_world), in_world.w};
  }
  return planes;
}

// Whether the points' convex hull is outside the view.
bool is_outside(const View& view, const Points& points) {
  return std::any_of(view.begin(), view.end(), [&](const Plane& plane) {
    return std::all_of(points.begin(), points.end(), [&](const glm::dvec3& p) {
      return glm::dot(plane.normal, p) + plane.offset < 0.0;
    });
  });
}

struct Box {
  glm::dvec3 low{0.0}, high{0.0};
};

Box box_of(const Points& points) {
  Box box{points.front(), points.front()};
  for (const glm::dvec3& p : points) {
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  }
  return box;
}

// Metres that the points must move until all of them have left the box on one of its sides.
double way_through(const Points& points, const Box& box, const glm::dvec3& direction) {
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0) continue;
    const double side = direction[axis] > 0.0 ? box.high[axis] : box.low[axis];
    double way = 0.0;
    for (const glm::dvec3& p : points) way = std::max(way, (side - p[axis]) / direction[axis]);
    least = std::min(least, way);
  }
  return least;
}

// The corners of the box's shadow volume as far as the receivers: the box's own, and the same moved
// behind the last receiver.
Points shaded_by(const Points& caster, const Points& receivers, const scene::Light& light) {
  Points points = caster;
  if (light.kind == scene::Light::Kind::Directional) {
    const glm::dvec3 away = -glm::normalize(glm::dvec3(light.to_light));
    const double way = way_through(caster, box_of(receivers), away);
    for (const glm::dvec3& p : caster) points.push_back(p + way * away);
    return points;
  }
  const glm::dvec3 position(light.position);
  double farthest = 0.0;
  for (const glm::dvec3& p : receivers) farthest = std::max(farthest, glm::distance(p, position));
  // One factor for all corners, from the box's point nearest to the light. It moves every point of
  // the box at least as far as the farthest receiver.
  const Box box = box_of(caster);
  const double nearest = glm::distance(glm::clamp(position, box.low, box.high), position);
  constexpr double kMostDrawnOut = 1e6;
  const double factor = nearest > 0.0 ? std::min(farthest / nearest, kMostDrawnOut) : kMostDrawnOut;
  for (const glm::dvec3& p : caster)
    points.push_back(position + std::max(factor, 1.0) * (p - position));
  return points;
}

}  // namespace

bool nothing_virtual_in_view(const scene::Scene& scene, std::span<const scene::Bounds> mesh_bounds,
                             const passes::RenderView& view) {
  const View planes = view_planes(view);
  std::vector<Points> casters;
  Points receivers;
  for (const scene::AnchoredInstance& anchored : view.scene.instances) {
    const scene::Instance& instance = scene.instances[anchored.instance];
    const auto corners = placed_corners(mesh_bounds[instance.mesh], anchored.world_from_mesh);
    const Points box(corners.begin(), corners.end());
    if (instance.role == scene::Role::Virtual) {
      if (!is_outside(planes, box)) return false;
      casters.push_back(box);
    } else if (!is_outside(planes, box)) {
      if (scene::is_specular(scene.materials[instance.material].kind)) return false;
      receivers.insert(receivers.end(), box.begin(), box.end());
    }
    if (casters.size() * std::max<std::size_t>(view.lights.size(), 1) > kMostPairs) return false;
  }
  if (receivers.empty()) return true;
  return std::all_of(casters.begin(), casters.end(), [&](const Points& caster) {
    return std::all_of(view.lights.begin(), view.lights.end(), [&](const scene::Light& light) {
      return is_outside(planes, shaded_by(caster, receivers, light));
    });
  });
}

}  // namespace amalgam::frame
