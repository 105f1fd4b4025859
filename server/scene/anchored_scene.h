// Anchors a scene for one frame of one camera: from marker poses to world-frame transforms.
//
// The world frame is the world marker's (glTF axes: +Y out of the paper). If that marker is unseen,
// the seen marker with the lowest id that objects are bound to stands in for it, so that its
// objects still show.
//
// Floats of a scene a thousand kilometres from its marker (in coordinates of a map, say) would be
// 6 cm apart. So where the first of the world's objects is more than 100 m from the marker, the
// world's origin is there, and it is subtracted in double before anything becomes float (numerics
// B13). Poses do not move it.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/pose.h"
#include "scene/light/light.h"
#include "scene/scene.h"

namespace amalgam::scene {

struct AnchoredInstance {
  std::uint32_t instance = 0;  // index into Scene::instances
  glm::mat4 world_from_mesh{1.0f};
  bool operator==(const AnchoredInstance&) const = default;
};

struct AnchoredScene {
  glm::dmat4 camera_from_world{1.0};        // rigid; camera: x right, y down, z forward
  std::vector<AnchoredInstance> instances;  // those whose marker is seen, in scene order
  std::vector<Light> punctual_lights;       // those whose marker is seen
  int world_marker = 0;                     // the marker whose frame is the world
  glm::dvec3 world_origin{0.0};             // the world's origin in the marker's frame
  bool operator==(const AnchoredScene&) const = default;
};

// Unusable poses (common::is_usable) are ignored. Without a pose of any marker that has objects, no
// instance is anchored.
AnchoredScene anchor_scene(const Scene& scene, std::span<const common::MarkerPose> poses);

}  // namespace amalgam::scene
