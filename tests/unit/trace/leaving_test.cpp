// Shadow and visibility rays leave their surface however flat they are, and miss nothing near it
// (numerics B1, B2).
#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "trace/fresnel.h"
#include "trace/shadow.h"
#include "trace/surface_point.h"
#include "trace/visibility_walk.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr Hit kOnFloor{0, 0, {0.3, 0.2}, 1.0};
const auto kWhite = test_support::make_diffuse(glm::vec3(1.0f));

// The scene's first object is the floor that rays leave.
class Leaving : public testing::Test {
 protected:
  void place() {
    embree_.emplace(scene_);
    embree_->place(anchor_all(scene_));
    point_ = surface_point(*embree_, kOnFloor, {0, -1, 0});
  }
  Ray ray_towards(const glm::dvec3& direction) const {
    return {point_.ray_origin_on_line(direction), glm::vec3(direction), kFar};
  }
  ShadowAttenuation shadow(const glm::dvec3& direction) const {
    PassedSurfaces surfaces;
    return trace_shadow(*embree_, point_.position, ray_towards(direction), surfaces);
  }
  int surfaces_visited(const glm::dvec3& direction) const {
    int visited = 0;
    walk_visibility(*embree_, point_.position, ray_towards(direction), Visible::Everything,
                    [&](const SurfacePoint&, double) {
                      ++visited;
                      return std::optional(Visible::Everything);
                    });
    return visited;
  }
  // Across x at this distance from the point, both in the world.
  void add_wall(double distance, const scene::Material& material) {
    // Its mesh begins at x = 0, so that its place is exact to a unit of the distance.
    add_object(
        scene_, test_support::make_quad({0, 0, 0}, {0, 0, 4}, {0, 4, 0}), material,
        scene::Role::Virtual,
        glm::translate(glm::mat4(1.0f), glm::vec3(glm::dvec3(distance + point_.position.x, 0, 0))));
    place();
  }

  scene::Scene scene_;
  std::optional<EmbreeScene> embree_;
  SurfacePoint point_;
};

// Of both triangles of a floor that lies aslant in the world, and as far away as it is wide.
TEST_F(Leaving, FlatRaysDoNotMeetTheirFloor) {
  for (const bool glass_elsewhere : {false, true}) {
    for (float turn = 0.0f; turn < 6.0f; turn += 0.3f) {
      scene_ = {};
      const glm::mat4 place_of_floor =
          glm::rotate(glm::translate(glm::mat4(1.0f), {1.3f, -0.7f, 2.1f}), turn,
                      glm::normalize(glm::vec3(0.2f, 0.5f, 0.7f)));
      add_object(scene_, test_support::make_floor(0.0f, 2.0f), kWhite, scene::Role::Real,
                 place_of_floor);
      if (glass_elsewhere) {
        add_object(scene_, test_support::make_floor(-90.0f, 0.1f), test_support::make_glass(1.5f),
                   scene::Role::Real);
      }
      place();
      const glm::dvec3 up = glm::normalize(glm::dmat3(place_of_floor) * glm::dvec3(0, 1, 0));
      for (int i = 0; i < 200; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 200.0;
        const glm::dvec3 along =
            glm::dmat3(place_of_floor) * glm::dvec3(std::cos(angle), 0, std::sin(angle));
        const double rise = std::pow(10.0, -1.0 - 4.0 * i / 200.0);  // 0.1 to 1e-5
        const glm::dvec3 direction = glm::normalize(along + rise * up);
        EXPECT_EQ(shadow(direction).real, glm::vec3(1.0f)) << turn << ' ' << rise;
        EXPECT_EQ(surfaces_visited(direction), 0) << turn << ' ' << rise;
      }
    }
  }
}

// A flat ray once began up to a thousand offsets along its line, beyond such a wall.
TEST_F(Leaving, MeetsWhatIsNear) {
  for (const double offsets : {0.25, 1.0, 10.0, 900.0}) {
    for (const double rise : {1e-5, 1e-3, 0.1}) {
      scene_ = {};
      add_object(scene_, test_support::make_floor(0.0f, 2.0f), kWhite, scene::Role::Real);
      place();
      const glm::dvec3 direction = glm::normalize(glm::dvec3(1, rise, 0));
      const scene::Material glass = test_support::make_glass(1.5f);
      add_wall(offsets * point_.offset, glass);
      EXPECT_NEAR(shadow(direction).mixed.x,
                  shadow_transmittance(static_cast<float>(direction.x), 1.5f, glass.thin), 1e-6f)
          << offsets << ' ' << rise;
      EXPECT_EQ(surfaces_visited(direction), 1) << offsets << ' ' << rise;
    }
  }
}

// Behind the point, and as near.
TEST_F(Leaving, DoesNotMeetWhatIsBehind) {
  for (const double offsets : {0.25, 0.9}) {
    scene_ = {};
    add_object(scene_, test_support::make_floor(0.0f, 2.0f), kWhite, scene::Role::Real);
    place();
    add_wall(-offsets * point_.offset, kWhite);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(1, 0.1, 0));
    EXPECT_EQ(shadow(direction).mixed, glm::vec3(1.0f)) << offsets;
    EXPECT_EQ(surfaces_visited(direction), 0) << offsets;
  }
}

}  // namespace
}  // namespace amalgam::trace
