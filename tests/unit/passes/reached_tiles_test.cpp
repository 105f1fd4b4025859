#include "passes/reached_tiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "support/scene_builders.h"
#include "unit/passes/raster_rig.h"

namespace amalgam::passes {
namespace {

using namespace test_support;
using scene::Role;

TEST(CasterCells, GiveNoLessThanAnyTexelWithin) {
  constexpr int kSide = 37;  // no multiple of a cell's
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  std::vector<float> depths(kSide * kSide, 0.0f);
  for (int i = 0; i < 40; ++i) depths[random() % depths.size()] = uniform(random);
  const CasterCells cells = CasterCells::of_depths(depths, kSide);
  for (int i = 0; i < 2000; ++i) {
    const int x = static_cast<int>(random() % kSide), y = static_cast<int>(random() % kSide);
    const glm::dvec2 at((x + 0.5) / kSide, (y + 0.5) / kSide);
    const glm::dvec2 reach(0.6 * uniform(random));
    EXPECT_GE(cells.nearest_depth(0, at - reach, at + reach),
              depths[static_cast<std::size_t>(y * kSide + x)]);
  }
  EXPECT_EQ(cells.nearest_depth(0, {1.1, 0.0}, {1.5, 1.0}), 0.0f);
  EXPECT_FALSE(cells.is_empty(0));
  EXPECT_TRUE(CasterCells::of_depths(std::vector<float>(64, 0.0f), 8).is_empty(0));
}

// A scene, lights and a camera by chance: tiny and huge casters, glass and mirrors, above, below
// and behind everything, under suns, lamps and spots.
struct RandomFrame {
  scene::Scene scene;
  std::vector<scene::Light> lights;
  core::CameraModel camera;
  glm::dmat4 camera_from_world{1.0};
  int samples_per_side = 1;

  explicit RandomFrame(unsigned seed) : random_(seed) {
    add_object(scene, make_floor(0.0f, range(0.3f, 2.0f)), make_diffuse(glm::vec3(0.6f)),
               Role::Real);
    const int objects = 1 + static_cast<int>(random_() % 6);
    for (int i = 0; i < objects; ++i) add_any_object();
    const int count = 1 + static_cast<int>(random_() % 10);
    const bool suns_only = random_() % 2 == 0;
    for (int i = 0; i < count; ++i) add_any_light(suns_only);
    const int width = 40 + static_cast<int>(random_() % 120);
    camera = make_pinhole(width, 30 + static_cast<int>(random_() % 90),
                          range(0.4f, 2.0f) * static_cast<float>(width));
    camera.cx += range(-9.0f, 9.0f);
    const glm::dvec3 eye(range(-0.6f, 0.6f), range(0.03f, 0.9f), range(-0.6f, 0.6f));
    camera_from_world = look_at(eye, {range(-0.2f, 0.2f), range(-0.05f, 0.1f), 0.0});
    samples_per_side = 1 + static_cast<int>(random_() % 3);
  }

  RenderView view() const {
    return make_view(scene, camera, camera_from_world, lights, samples_per_side);
  }

 private:
  float range(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }

  void add_any_object() {
    const float size = std::pow(10.0f, range(-2.7f, -0.3f));  // 2 mm to 0.5 m
    const glm::vec3 at(range(-0.5f, 0.5f), range(-0.2f, 0.8f), range(-0.5f, 0.5f));
    glm::mat4 place = glm::translate(glm::mat4(1.0f), at);
    place = glm::rotate(place, range(0.0f, 6.0f), glm::normalize(glm::vec3(1.0f, at.x, at.z)));
    place = glm::scale(
        place, size * glm::vec3(1.0f, range(0.2f, 1.0f), random_() % 4 != 0 ? 1.0f : -1.0f));
    scene::Mesh mesh = random_() % 2 == 0 ? make_box(glm::vec3(-0.5f), glm::vec3(0.5f))
                                          : make_sphere(glm::vec3(0.0f), 0.5f, 12, 8);
    if (random_() % 4 == 0) mesh = make_floor(0.0f, 0.5f);
    scene::Material material = make_diffuse(glm::vec3(range(0.0f, 1.0f), 0.5f, 0.2f));
    if (random_() % 3 == 0) material = make_mirror();
    if (random_() % 3 == 0) material = make_glass(1.5f, glm::vec3(range(0.0f, 20.0f)));
    material.thin = random_() % 2 == 0;
    add_object(scene, std::move(mesh), material, random_() % 3 == 0 ? Role::Real : Role::Virtual,
               place);
  }

  void add_any_light(bool suns_only) {
    const glm::vec3 to(range(-1.0f, 1.0f), range(-0.1f, 1.0f), range(-1.0f, 1.0f));
    if (suns_only || random_() % 2 == 0) {
      lights.push_back(make_sun(to, glm::vec3(range(0.1f, 3.0f))));
      return;
    }
    scene::Light light = make_point_light({to.x, range(-0.1f, 1.0f), to.z}, glm::vec3(0.4f));
    if (random_() % 2 == 0) {
      light.kind = scene::Light::Kind::Spot;
      light.to_light = glm::normalize(to + glm::vec3(0.0f, 0.2f, 0.0f));
      light.cos_outer = range(0.1f, 0.95f);
      light.cos_inner = light.cos_outer + 0.04f;
    }
    lights.push_back(light);
  }

  std::mt19937 random_;
};

// A tile wrongly left out would lack a shadow.
TEST(ReachedTiles, LeaveOutNothingThatTheWholePictureShows) {
  std::size_t reached = 0, all = 0, showing = 0;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const RandomFrame random(seed);
    RasterRig rig(random.scene);
    rig.shadow_options.size = seed % 3 == 0 ? 0 : seed % 3 == 1 ? 100 : 333;
    const RasterFrame whole = rig.render(random.view(), 0.8f);
    rig.leave_out_tiles = true;
    const RasterFrame by_tile = rig.render(random.view(), 0.8f);
    EXPECT_EQ(whole.diffuse_effect, by_tile.diffuse_effect) << "seed " << seed;
    ASSERT_EQ(whole.layers.has_value(), by_tile.layers.has_value()) << "seed " << seed;
    if (!whole.layers) continue;
    EXPECT_EQ(whole.layers->present(), by_tile.layers->present()) << "seed " << seed;
    EXPECT_EQ(whole.layers->over_image(), by_tile.layers->over_image()) << "seed " << seed;
    EXPECT_EQ(whole.layers->difference_image(), by_tile.layers->difference_image())
        << "seed " << seed;
    EXPECT_EQ(whole.nonfinite, by_tile.nonfinite);
    reached += by_tile.reached.size();
    all += whole.reached.size();
    showing += whole.layers->present().size();
  }
  EXPECT_GT(showing, 200u);
  EXPECT_LT(reached, all);
  RecordProperty("reached", static_cast<int>(reached));
  RecordProperty("all", static_cast<int>(all));
  RecordProperty("showing", static_cast<int>(showing));
}

}  // namespace
}  // namespace amalgam::passes
