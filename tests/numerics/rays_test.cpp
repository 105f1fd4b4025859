// numerics B11 and B12: rays that no closed mesh may let out, and rays from far away.
//
// AMALGAM_LONG_TESTS=1 sends ten million rays for each instruction set, and not a hundred thousand.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <random>

#include "numerics/icosphere.h"
#include "numerics/isa.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

class RandomDirection {
 public:
  explicit RandomDirection(unsigned seed) : random_(seed) {}
  glm::vec3 operator()() {
    return glm::normalize(glm::vec3(normal_(random_), normal_(random_), normal_(random_)));
  }

 private:
  std::mt19937 random_;
  std::normal_distribution<float> normal_;
};

// Where rays from inside a closed sphere are sent.
enum class Aim { Anywhere, Edges, Corners };

class ClosedSphere {
 public:
  ClosedSphere() {
    add_object(scene_, test_support::make_icosphere(4), test_support::make_mirror(),
               scene::Role::Virtual);
    embree_.emplace(scene_);
    embree_->place(anchor_all(scene_));
  }

  int misses(int rays, Aim aim) const {
    RandomDirection direction(11);
    int misses = 0;
    for (int i = 0; i < rays; ++i) {
      const glm::vec3 start = 0.9f * direction();
      const glm::vec3 to =
          aim == Aim::Anywhere ? direction() : glm::normalize(target(i, aim) - start);
      misses += embree_->intersect({start, to, kInfinity}, Visible::Everything) ? 0 : 1;
    }
    return misses;
  }

 private:
  glm::vec3 target(int i, Aim aim) const {
    const scene::Mesh& mesh = scene_.meshes[0];
    const glm::uvec3& t = mesh.triangles[static_cast<std::size_t>(i) % mesh.triangles.size()];
    const glm::vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y];
    const float along = 0.1f + 0.8f * static_cast<float>(i % 97) / 97.0f;
    return aim == Aim::Corners ? a : a + along * (b - a);
  }

  scene::Scene scene_;
  std::optional<EmbreeScene> embree_;
};

TEST(Rays, NoneLeavesAClosedSphereWithAnyInstructionSet) {
  const int rays = std::getenv("AMALGAM_LONG_TESTS") != nullptr ? 10'000'000 : 100'000;
  for (const std::string& isa : usable_isas()) {
    const test_support::ChosenIsa chosen(isa);
    const ClosedSphere sphere;
    const int anywhere = sphere.misses(rays, Aim::Anywhere);
    const int edges = sphere.misses(rays, Aim::Edges);
    const int corners = sphere.misses(rays, Aim::Corners);
    std::printf("%s, misses in %d rays: %d anywhere, %d at edges, %d at corners\n", isa.c_str(),
                rays, anywhere, edges, corners);
    EXPECT_LE(anywhere, rays / 10'000'000) << isa;
    EXPECT_LE(edges, rays / 10'000'000) << isa;
    // Beyond: a ray at a corner to a float's last digit can have every triangle there on its same
    // side, because each edge is rounded apart.
    EXPECT_LT(corners, rays / 100) << isa;
    EXPECT_GT(corners, 0) << isa << ": the limit in tests/README.md has become better";
  }
}

// Hits, of a thousand rays, on a box two metres wide from this far away.
int hits_from(float far) {
  scene::Scene scene;
  add_object(scene, test_support::make_box(glm::vec3(-1.0f), glm::vec3(1.0f)),
             test_support::make_mirror(), scene::Role::Virtual);
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  RandomDirection direction(12);
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 away = direction();
    const auto hit = embree.intersect({far * away, -away, kInfinity}, Visible::Everything);
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(hit->t / double{far}, 1.0, 2.0 / double{far} + 1e-6) << far;
  }
  return hits;
}

TEST(Rays, MeetABoxFromFiveMillionTimesItsSize) {
  for (const float far : {1e1f, 1e3f, 1e5f, 1e6f, 1e7f}) EXPECT_EQ(hits_from(far), 1000) << far;
  // Beyond: a float's last digit in the direction is wider than the box.
  EXPECT_LT(hits_from(1e8f), 500);
  EXPECT_EQ(hits_from(1e11f), 0);
}

// A wall as wide as the distance is still met, until the ray's numbers are none that Embree takes.
TEST(Rays, AreRaysUpToATrillionMetres) {
  scene::Scene scene;
  add_object(scene, test_support::make_floor(0.0f, 1e13f), test_support::make_mirror(),
             scene::Role::Virtual);
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  const auto meets_from = [&](float height) {
    return embree.intersect({{1, height, 2}, {0, -1, 0}, kInfinity}, Visible::Everything)
        .has_value();
  };
  for (const float height : {1.0f, 1e6f, 0.9e12f}) EXPECT_TRUE(meets_from(height)) << height;
  for (const float height : {1.1e12f, 1e20f, 3e38f}) EXPECT_FALSE(meets_from(height)) << height;
}

}  // namespace
}  // namespace amalgam::trace
