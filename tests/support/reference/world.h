// All surfaces of an anchored scene in the world frame, and what a ray meets of them.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/anchored_scene.h"
#include "scene/scene.h"
#include "support/reference/bounding_tree.h"
#include "support/reference/primitives.h"
#include "support/reference/surface_material.h"

namespace amalgam::reference {

struct Object {
  scene::Material material;  // without textures that the mesh has no coordinates for
  std::uint32_t medium = 0;  // the same number: the same glass
  scene::Role role = scene::Role::Virtual;
  // What its points' coordinates are sums of, at most: a corner's way from the mesh's origin, and
  // that one's from the world's. Metres; rounding is in proportion to this.
  double coordinate_size = 0.0;
};

struct Geometry {
  std::vector<Triangle> triangles;
  std::vector<TriangleAttributes> attributes;  // of each triangle
  std::vector<Ball> balls;
  std::vector<Object> objects;  // of which primitives are part
};

// The anchored instances' triangles; object i is anchored.instances[i].
Geometry make_geometry(const scene::Scene& scene, const scene::AnchoredScene& anchored);

class World {
 public:
  // The textures must outlive the world.
  World(Geometry geometry, std::span<const scene::Texture> textures);

  const Geometry& geometry() const { return geometry_; }
  const Object& object(const Hit& hit) const { return geometry_.objects[hit.object]; }

  // What the surface is made of at that point; for its normal, which side does not matter.
  SurfaceMaterial material(const Hit& hit) const { return surface_material(place(hit)); }

  // The nearest surface. Those whose alpha lies below their cut-off are not there.
  std::optional<Hit> closest(Ray ray) const;

  // Every surface on the ray's way in no particular order, until visit(hit) returns false.
  template <typename Visit>
  void for_each_hit(const Ray& ray, const Visit& visit) const {
    tree_.for_each_candidate(ray, [&](std::uint32_t primitive) {
      auto hit = intersect_primitive(ray, primitive);
      while (hit) {
        if (exists(*hit) && !visit(*hit)) return false;
        if (!is_ball(primitive)) break;
        Ray rest = ray;
        rest.t_min = std::nextafter(hit->t, kInfinity);
        hit = intersect_primitive(rest, primitive);
      }
      return true;
    });
  }

 private:
  bool is_ball(std::uint32_t primitive) const { return primitive >= geometry_.triangles.size(); }
  std::optional<Hit> intersect_primitive(const Ray& ray, std::uint32_t primitive) const;
  SurfacePlace place(const Hit& hit) const;
  bool exists(const Hit& hit) const;

  Geometry geometry_;
  std::span<const scene::Texture> textures_;
  BoundingTree tree_;  // over triangles, then balls
};

}  // namespace amalgam::reference
