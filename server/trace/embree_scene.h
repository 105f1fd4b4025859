// The scene in Embree: one static BVH for each mesh, and instances of them that poses move.
//
// The only user of Embree. World frame, metres.
#pragma once

#include <algorithm>
#include <array>
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
#include "scene/bounds.h"
#include "scene/scene.h"
#include "trace/mesh_triangle.h"

namespace amalgam::trace {

// Which objects a ray can meet. Values are Embree's mask bits.
enum class Visible : std::uint32_t { Real = 1, Virtual = 2, Everything = 3 };

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

// An instance placed in the world.
struct PlacedInstance {
  void place(const glm::mat4& placement);

  glm::dmat4 world_from_mesh{1.0};
  glm::dmat4 mesh_from_world{1.0};
  // Transforms normals. Cofactors, so that singular scales cannot divide by zero, times the sign of
  // the determinant, so that outside stays outside under mirroring (numerics B23).
  glm::dmat3 normal_from_mesh{1.0};
  double stretch = 1.0;  // largest element of the linear part
  double reach = 0.0;    // largest coordinate of the translation, metres

  const MeshTriangle* triangles = nullptr;  // the mesh's
  std::uint32_t material = 0;               // index into Scene::materials
  scene::Role role = scene::Role::Virtual;
  bool textured = false;  // the material varies over the surface: textures or vertex colors
};

// The surfaces that a shadow ray passes, up to kMost. Further ones are only counted: see
// overflowed().
class PassedSurfaces {
 public:
  static constexpr std::size_t kMost = 256;  // so that no mesh makes a ray endless

  void add(const Hit& hit) {
    if (count_ < kMost) hits_[count_] = hit;
    ++count_;
  }
  void clear() { count_ = 0; }
  bool overflowed() const { return count_ > kMost; }
  std::span<Hit> hits() { return {hits_.data(), std::min(count_, kMost)}; }

 private:
  std::array<Hit, kMost> hits_;
  std::size_t count_ = 0;
};

class EmbreeScene {
 public:
  // Builds the static BVHs. Throws std::runtime_error if Embree cannot start, or not with the
  // instruction set asked for (trace/embree_isa.h), or if it has no memory.
  explicit EmbreeScene(const scene::Scene& scene);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  // Whether all instances already have this frame's transforms.
  bool is_placed(const scene::AnchoredScene& anchored) const;

  // Moves the instances that have not and commits the top level. Must not run while rays are
  // traced. Instances that Embree cannot count with (trace/embree_range.h) are left out, and named
  // in the log once. Throws std::runtime_error if Embree has no memory; everything is placed anew
  // then by the next call.
  void place(const scene::AnchoredScene& anchored);

  // The nearest hit. Rays that are not finite, or start out of range, meet nothing (numerics B12).
  std::optional<Hit> intersect(const Ray& ray, Visible visible) const;
  bool is_occluded(const Ray& ray, Visible visible) const;

  // The following are for rays that leave a surface at start: what they leave behind there does not
  // count (is_left_behind() in trace/refine_hit.h).
  bool is_occluded(const glm::dvec3& start, const Ray& ray, Visible visible) const;
  // Every surface on the ray, unordered. Hits on edges and on split triangles occur more than once.
  // Stops and returns true at a real surface that is opaque everywhere; the list is then
  // incomplete.
  bool find_all(const glm::dvec3& start, const Ray& ray, Visible visible,
                PassedSurfaces& found) const;

  const scene::Scene& scene() const { return scene_; }
  // Whether the scene has any surface that light can pass: glass or alpha cut-outs.
  bool anything_passes_light() const { return anything_passes_light_; }
  const PlacedInstance& placed(std::uint32_t instance) const { return placed_[instance]; }
  // Whether the instance was in the last frame that was placed.
  bool is_in_frame(std::uint32_t instance) const { return last_placed_[instance].has_value(); }
  // Its box, aligned with the world's axes, metres.
  scene::Bounds world_bounds(std::uint32_t instance) const;
  const MeshTriangle& triangle(const Hit& hit) const {
    return placed_[hit.instance].triangles[hit.triangle];
  }

 private:
  struct Impl;
  using Placements = std::vector<std::optional<glm::mat4>>;  // none: not in the frame
  Placements placements(const scene::AnchoredScene& anchored) const;
  void name_untraceable(const scene::AnchoredScene& anchored);
  bool is_valid(const Ray& ray) const;

  const scene::Scene& scene_;
  std::vector<std::vector<MeshTriangle>> triangles_;  // by Scene::meshes
  std::vector<scene::Bounds> mesh_bounds_;            // by Scene::meshes
  // By Scene::instances.
  std::vector<PlacedInstance> placed_;
  std::vector<std::uint8_t> ends_light_;  // real and opaque everywhere
  std::vector<std::uint8_t> named_;       // in the log, as untraceable
  bool anything_passes_light_ = false;
  double start_range_ = 0.0;  // of all placed instances (trace/embree_range.h)
  Placements last_placed_;
  bool whole_ = true;  // the last placing did not fail
  std::unique_ptr<Impl> impl_;
};

}  // namespace amalgam::trace
