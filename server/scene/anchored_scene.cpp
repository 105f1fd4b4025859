#include "scene/anchored_scene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <optional>

namespace amalgam::scene {
namespace {

using MarkerPoses = std::map<int, glm::dmat4>;  // camera_from_anchor (glTF axes)

MarkerPoses usable_poses(std::span<const common::MarkerPose> poses) {
  MarkerPoses usable;
  for (const common::MarkerPose& pose : poses) {
    if (common::is_usable(pose)) {
      usable.emplace(pose.marker, common::to_matrix(pose) * common::opencv_marker_from_gltf());
    }
  }
  return usable;
}

// The world marker if it is seen, otherwise the first seen marker that something is bound to.
std::optional<int> choose_world(const Scene& scene, const MarkerPoses& poses) {
  if (poses.contains(scene.world.marker)) return scene.world.marker;
  for (const auto& [marker, pose] : poses) {
    for (const Instance& instance : scene.instances) {
      if (instance.marker == marker) return marker;
    }
  }
  return std::nullopt;
}

// In whole metres, so that sums with it stay exact.
glm::dvec3 choose_origin(const Scene& scene, int world) {
  constexpr double kNear = 100.0;
  for (const Instance& instance : scene.instances) {
    if (instance.marker.value_or(scene.world.marker) != world) continue;
    const glm::dvec3 first(instance.anchor_from_mesh[3]);
    return glm::length(first) > kNear ? glm::round(first) : glm::dvec3(0.0);
  }
  return glm::dvec3(0.0);
}

}  // namespace

AnchoredScene anchor_scene(const Scene& scene, std::span<const common::MarkerPose> poses) {
  AnchoredScene anchored;
  const MarkerPoses seen = usable_poses(poses);
  const std::optional<int> world = choose_world(scene, seen);
  if (!world) return anchored;

  anchored.world_marker = *world;
  anchored.world_origin = choose_origin(scene, *world);
  const auto moved = [](const glm::dvec3& by) { return glm::translate(glm::dmat4(1.0), by); };
  anchored.camera_from_world = seen.at(*world) * moved(anchored.world_origin);
  const glm::dmat4 world_from_camera = common::rigid_inverse(anchored.camera_from_world);

  // Nothing but the origin for what stands on the world marker, so that it is seen not to move.
  const auto world_from_anchor = [&](const std::optional<int>& bound) -> std::optional<glm::dmat4> {
    const int marker = bound.value_or(scene.world.marker);
    if (marker == *world) return moved(-anchored.world_origin);
    const auto found = seen.find(marker);
    if (found == seen.end()) return std::nullopt;
    return world_from_camera * found->second;
  };

  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    if (const auto anchor = world_from_anchor(instance.marker)) {
      anchored.instances.push_back({i, glm::mat4(*anchor * instance.anchor_from_mesh)});
    }
  }
  for (const PunctualLight& punctual : scene.punctual_lights) {
    const auto anchor = world_from_anchor(punctual.marker);
    if (!anchor) continue;
    const glm::dmat4 world_from_light = *anchor * punctual.anchor_from_light;
    Light light;
    light.kind = punctual.kind;
    light.to_light = glm::vec3(glm::normalize(glm::dvec3(world_from_light[2])));
    light.position = glm::vec3(world_from_light[3]);
    light.intensity = punctual.intensity;
    light.range = punctual.range;
    light.cos_inner = punctual.cos_inner;
    light.cos_outer = punctual.cos_outer;
    anchored.punctual_lights.push_back(light);
  }
  return anchored;
}

}  // namespace amalgam::scene
