// numerics B11 and B12: rays that no closed mesh may let out, and rays from far away.
//
// AMALGAM_LONG_TESTS=1 sends ten million rays for each instruction set, and not a hundred thousand.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
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

TEST(Rays, NoneLeavesAClosedSphereWithAnyInstructionSet) {
  const int rays = std::getenv("AMALGAM_LONG_TESTS") != nullptr ? 10'000'000 : 100'000;
  for (const std::string& isa : usable_isas()) {
    const test_support::ChosenIsa chosen(isa);
    scene::Scene scene;
    add_object(scene, test_support::make_icosphere(4), test_support::make_mirror(),
               scene::Role::Virtual);
    EmbreeScene embree(scene);
    embree.place(anchor_all(scene));
    RandomDirection direction(11);
    int misses = 0;
    for (int i = 0; i < rays; ++i) {
      // From all over the inside, and at corners of the mesh, where many edges meet.
      const glm::vec3 start = 0.9f * direction();
      const glm::vec3& corner =
          scene.meshes[0].positions[static_cast<std::size_t>(i) % scene.meshes[0].positions.size()];
      const glm::vec3 to = i % 4 == 0 ? glm::normalize(corner - start) : direction();
      misses += embree.intersect({start, to, kInfinity}, Visible::Everything) ? 0 : 1;
    }
    std::printf("%s: %d of %d rays missed\n", isa.c_str(), misses, rays);
    EXPECT_LE(misses, rays / 10'000'000) << isa;
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

TEST(Rays, MeetABoxFromAMillionTimesItsSize) {
  for (const float far : {1e1f, 1e3f, 1e5f, 1e6f}) EXPECT_EQ(hits_from(far), 1000) << far;
  // Beyond: a float's last digit in the direction is as wide as the box.
  for (const float far : {1e7f, 1e8f, 1e9f, 1e11f, 1e12f, 1e20f})
    std::printf("%g: %d\n", double{far}, hits_from(far));
  EXPECT_LT(hits_from(1e8f), 500);
  EXPECT_EQ(hits_from(1e12f), 0) << "not a ray any more";
}

}  // namespace
}  // namespace amalgam::trace
