#include "passes/raster/reached_tiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
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
  common::CameraModel camera;
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

// The least depth that a look-up compares with: that of the steepest plane through the point which
// shaders/shadow.glsl follows, at the far corner of the four texels around it.
double least_depth(const ShadowLayout& layout, std::size_t layer, const glm::dvec3& p) {
  const glm::dmat4 clip_from_world(layout.layers[layer].clip_from_world);
  const glm::dvec4 clip = clip_from_world * glm::dvec4(p, 1.0);
  const double texel = layout.texels[0];
  const double rise = std::sqrt(2.0) * texel / gl::kLeastShadowCosine;
  if (layout.layers[layer].perspective != 0) return (1.0 - rise) * clip.z / clip.w;
  const glm::dvec3 along(clip_from_world[0][2], clip_from_world[1][2], clip_from_world[2][2]);
  return clip.z - rise * glm::length(along);
}

// Whether a look-up of the point may find a caster in the map, if the point's surface is steep.
bool is_shaded(const ShadowLayout& layout, std::size_t layer, const std::vector<float>& map,
               const glm::dvec3& p, bool cube_side) {
  const glm::dvec4 clip = glm::dmat4(layout.layers[layer].clip_from_world) * glm::dvec4(p, 1.0);
  // Depth 0 is behind everything that there is.
  if (!(clip.w > 0.0) || !(clip.z > 0.0)) return false;
  // A cube's side is asked only for what it sees best; the rest of it is room for the filter.
  const double inside = cube_side ? 1.0 / (1.0 + 4.0 / layout.size) : 1e9;
  if (std::max(std::abs(clip.x), std::abs(clip.y)) > inside * clip.w) return false;
  const glm::dvec2 at = (0.5 * glm::dvec2(clip) / clip.w + 0.5) * double(layout.size) - 0.5;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 2; ++x) {
      const int i = static_cast<int>(std::floor(at.x)) + x;
      const int j = static_cast<int>(std::floor(at.y)) + y;
      if (i < 0 || j < 0 || i >= layout.size || j >= layout.size) continue;
      const double stored = map[static_cast<std::size_t>(j * layout.size + i)];
      if (stored > std::max(least_depth(layout, layer, p), 0.0)) return true;
    }
  }
  return false;
}

// Single texels of casters, each barely in front of some point of the scene: every margin counts.
TEST(ReachedTiles, AreAllThatAnyPointsLookUpIsShadedIn) {
  const auto context = shared_context();
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int shaded_points = 0, left_out = 0;
  for (unsigned seed = 100; seed < 200; ++seed) {
    RandomFrame frame(seed);
    frame.lights.resize(1);
    const RenderView view = frame.view();
    const gl::GpuScene gpu_scene(frame.scene);
    const ShadowLayout layout = make_shadow_layout(view, gpu_scene, 128);
    const core::TileGrid grid({view.ideal.width, view.ideal.height});
    const glm::dmat4 world_from_camera = common::rigid_inverse(view.scene.camera_from_world);
    std::vector<DepthRange> depths(grid.count());
    for (DepthRange& range : depths) {
      range.nearest = 0.05 + uniform(random);
      range.farthest = range.nearest * (1.0 + 0.1 * uniform(random));
    }
    const auto point_in = [&](std::size_t tile) {
      const glm::dvec2 first(grid.first_pixel(tile)), end(grid.end_pixel(tile));
      const auto pick = [&](double low, double high) {  // often at the very border
        const double t = uniform(random);
        return t < 0.3 ? low : t > 0.7 ? high : low + (high - low) * uniform(random);
      };
      const double z = pick(depths[tile].nearest, depths[tile].farthest);
      const glm::dvec2 pixel(pick(first.x, end.x - 1.0), pick(first.y, end.y - 1.0));
      const glm::dvec3 p(z * (pixel.x - view.ideal.cx) / view.ideal.fx,
                         z * (pixel.y - view.ideal.cy) / view.ideal.fy, z);
      return glm::dvec3(world_from_camera * glm::dvec4(p, 1.0));
    };
    for (std::size_t layer = 0; layer < layout.layers.size(); ++layer) {
      std::vector<float> map(static_cast<std::size_t>(layout.size * layout.size), 0.0f);
      for (int i = 0; i < 12; ++i) {
        const glm::dvec3 p = point_in(random() % grid.count());
        const glm::dvec4 clip =
            glm::dmat4(layout.layers[layer].clip_from_world) * glm::dvec4(p, 1.0);
        const glm::dvec2 at = 0.5 * glm::dvec2(clip) / clip.w + 0.5;
        if (!(clip.w > 0.0) || !(clip.z > 0.0) ||
            !(at.x >= 0.0 && at.x < 1.0 && at.y >= 0.0 && at.y < 1.0))
          continue;
        // One of the four that the filter reads.
        const glm::ivec2 texel = glm::clamp(glm::ivec2(glm::floor(at * double(layout.size) - 0.5)) +
                                                glm::ivec2(random() % 2, random() % 2),
                                            0, layout.size - 1);
        map[static_cast<std::size_t>(texel.y * layout.size + texel.x)] =
            static_cast<float>(std::max(least_depth(layout, layer, p), 0.0) * (1.0 + 1e-4) + 1e-12);
      }
      // The other layers stay empty.
      ShadowLayout one = layout;
      one.gpu_lights[0].first_layer = 0;
      one.gpu_lights[0].layer_count = 1;
      one.layers = {layout.layers[layer]};
      const CasterCells cells = CasterCells::of_depths(map, layout.size);
      const CasterCells* casters[] = {&cells};
      const auto shadowed = tiles_in_shadow(view, one, casters, depths);
      for (std::size_t tile = 0; tile < grid.count(); ++tile) {
        left_out += shadowed[tile] == 0 ? 1 : 0;
        for (int i = 0; i < 300; ++i) {
          if (!is_shaded(one, 0, map, point_in(tile), layout.layers.size() == 6)) continue;
          ++shaded_points;
          EXPECT_NE(shadowed[tile], 0)
              << "seed " << seed << ", tile " << tile << ", layer " << layer << " of "
              << layout.layers.size() << ", kind " << layout.gpu_lights[0].kind;
          break;
        }
      }
    }
  }
  EXPECT_GT(shaded_points, 100);
  EXPECT_GT(left_out, 1000);
}

// One layer of a light in the origin that looks along -z, 45 degrees to each side.
ShadowLayout spot_layout(int size) {
  glm::mat4 clip(0.0f);
  clip[0][0] = clip[1][1] = 1.0f;
  clip[3][2] = static_cast<float>(kNearPlane);
  clip[2][3] = -1.0f;
  ShadowLayout layout;
  layout.size = size;
  layout.layers.resize(1);
  layout.layers[0].clip_from_world = clip;
  layout.layers[0].perspective = 1;
  layout.gpu_lights.resize(1);
  layout.gpu_lights[0].layer_count = 1;
  layout.texels = {0.0f};
  return layout;
}

// A spot's map is asked a little beyond its border too, since the filter still reads a texel there:
// a tile of points that all lie within half a texel beyond, on each side.
TEST(ReachedTiles, WhatLiesJustBeyondASpotsBorderIsAsked) {
  constexpr int kSize = 16;
  const ShadowLayout layout = spot_layout(kSize);  // its texels have no size: no plane is steep
  // Something half way between the light and whatever is 1 m away, everywhere.
  const auto half_way = static_cast<float>(2.0 * kNearPlane);
  const CasterCells cells =
      CasterCells::of_depths(std::vector<float>(kSize * kSize, half_way), kSize);
  const CasterCells* casters[] = {&cells};
  const DepthRange depths[] = {{0.999, 1.001}};
  const auto shadowed = [&](const glm::dvec2& at) {
    // A tile of 16 mm at 1 m; at: in clip coordinates.
    const RenderView view = make_view(scene::Scene(), make_pinhole(16, 16, 1000.0),
                                      look_at(glm::dvec3(at, 0.0), glm::dvec3(at, -1.0)), {});
    return tiles_in_shadow(view, layout, casters, depths).front() != 0;
  };
  const double half_a_texel = 1.0 / kSize, four_texels = 8.0 / kSize;
  for (const glm::dvec2& side : {glm::dvec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
    EXPECT_TRUE(shadowed((1.0 + 0.7 * half_a_texel) * side)) << side.x << " " << side.y;
    EXPECT_FALSE(shadowed((1.1 + four_texels) * side)) << side.x << " " << side.y;
  }
}

// A spot's texels grow with the distance, and so does what a steep plane rises within them: a
// caster a little behind a far surface occludes it too.
TEST(ReachedTiles, WhatAPlaneRisesInATexelGrowsWithTheDistance) {
  constexpr int kSize = 16;
  constexpr double kDistance = 20.0;
  ShadowLayout layout = spot_layout(kSize);
  layout.texels[0] = 0.005f;  // for each metre. 0.005 * sqrt(2) * 64: up to 45 % of the distance
  const DepthRange depths[] = {{0.999 * kDistance, 1.001 * kDistance}};
  const RenderView view = make_view(scene::Scene(), make_pinhole(16, 16, 1000.0),
                                    look_at(glm::dvec3(0.0), glm::dvec3(0.0, 0.0, -1.0)), {});
  const auto shadowed = [&](double caster) {
    const CasterCells cells = CasterCells::of_depths(
        std::vector<float>(kSize * kSize, static_cast<float>(kNearPlane / caster)), kSize);
    const CasterCells* casters[] = {&cells};
    return tiles_in_shadow(view, layout, casters, depths).front() != 0;
  };
  EXPECT_TRUE(shadowed(kDistance - 1.0));
  EXPECT_TRUE(shadowed(1.7 * kDistance));
  EXPECT_FALSE(shadowed(2.0 * kDistance));
}

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
