// The scene as Embree sees it: one static BVH a mesh, and instances of them that poses move.
//
// The only user of Embree. World frame, metres.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "scene/anchored_scene.h"
#include "scene/scene.h"

namespace amalgam::trace {

// Which objects a ray can meet. Values are Embree's mask bits.
enum class Visible : std::uint32_t { Real = 1, Everything = 3 };

struct Ray {
  glm::vec3 origin{0.0f};
  glm::vec3 direction{0.0f};  // unit
  float t_max = 0.0f;         // metres; infinity for no end
  float t_min = 0.0f;
};

struct Hit {
  std::uint32_t instance = 0;   // index into Scene::instances
  std::uint32_t triangle = 0;   // index into the mesh's triangles
  glm::dvec2 barycentric{0.0};  // weights of the second and third corner
  double t = 0.0;               // metres; as Embree finds it, a float
};

// An instance placed in the world, with the matrix that carries its normals (cofactors, so that
// singular scales cannot divide by zero, times the sign of the determinant, so that outside stays
// outside under mirroring: numerics B23).
struct PlacedInstance {
  glm::dmat4 world_from_mesh{1.0};
  glm::dmat3 normal_from_mesh{1.0};
};

class EmbreeScene {
 public:
  // Builds the static BVHs. Throws std::runtime_error if Embree cannot be had.
  explicit EmbreeScene(const scene::Scene& scene);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  // Whether the instances are already where this frame has them.
  bool is_placed(const scene::AnchoredScene& anchored) const;

  // Moves those that are not and commits the top level. Not to be called while rays are traced.
  void place(const scene::AnchoredScene& anchored);

  // The nearest hit. Rays that are not finite meet nothing (numerics B12).
  std::optional<Hit> intersect(const Ray& ray, Visible visible) const;
  bool is_occluded(const Ray& ray, Visible visible) const;

  const scene::Scene& scene() const { return scene_; }
  const PlacedInstance& placed(std::uint32_t instance) const { return placed_[instance]; }

 private:
  struct Impl;
  using Placements = std::vector<std::optional<glm::mat4>>;  // none: not in the frame
  Placements placements(const scene::AnchoredScene& anchored) const;

  const scene::Scene& scene_;
  std::vector<PlacedInstance> placed_;  // by Scene::instances
  Placements last_placed_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace amalgam::trace
