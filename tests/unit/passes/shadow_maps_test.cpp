#include "passes/raster/shadow_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "support/scene_builders.h"
#include "unit/passes/raster_rig.h"

namespace amalgam::passes {
namespace {

using namespace test_support;

// From above, 1 m over a floor of 1 m x 1 m that fills the image: pixel x sees x_world = (x + 1/2)
// / 128 - 1/2, row y likewise z.
struct FloorView {
  common::CameraModel camera = make_pinhole(128, 128, 128.0);
  glm::dmat4 camera_from_world = look_at({0, 1, 0}, {0, 0, 0}, {0, 0, -1});
  glm::dvec3 point(int x, int y) const {
    return {(x + 0.5) / 128.0 - 0.5, 0.0, (y + 0.5) / 128.0 - 0.5};
  }
};

scene::Scene floor_and(const scene::Mesh& blocker, scene::Role blocker_role,
                       const scene::Material& material = make_diffuse(glm::vec3(0.5f))) {
  scene::Scene scene;
  add_object(scene, make_floor(0.0f, 0.5f), make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  add_object(scene, blocker, material, blocker_role);
  return scene;
}

// How far outside of the blocker (negative: inside) the way from p to the light passes, for a
// horizontal square of half side h at `height`, centred on the y axis.
double distance_outside(const glm::dvec3& p, const glm::dvec3& towards, double height, double h) {
  const glm::dvec3 at = p + towards * ((height - p.y) / towards.y);
  return std::max(std::abs(at.x), std::abs(at.z)) - h;
}

TEST(ShadowMaps, FallWhereTheLightCannotReach) {
  constexpr float kHeight = 0.2f, kHalf = 0.1f;
  const FloorView view;
  const scene::Light sun = make_sun({0.6f, 1.0f, 0.35f});
  scene::Light point = make_point_light({0.25f, 0.6f, 0.15f}, glm::vec3(1.0f));
  scene::Light spot = point;
  spot.kind = scene::Light::Kind::Spot;
  spot.to_light = glm::normalize(spot.position);  // its axis meets the origin
  spot.cos_inner = 0.75f;
  spot.cos_outer = 0.6f;
  scene::Light wide = spot;
  wide.cos_outer = 0.1f;  // wide enough for a cube
  const auto scene =
      floor_and(make_quad({0, kHeight, 0}, {kHalf, 0, 0}, {0, 0, -kHalf}), scene::Role::Virtual);
  RasterRig rig(scene);
  for (const scene::Light& light : {sun, point, spot, wide}) {
    const RasterFrame frame =
        rig.render(make_view(scene, view.camera, view.camera_from_world, {light}));
    int dark = 0, lit = 0;
    for (int y = 0; y < 128; ++y) {
      for (int x = 0; x < 128; ++x) {
        const glm::vec4 mixed = frame.mixed->at(x, y), real = frame.real->at(x, y);
        if (mixed.w != 0.0f) continue;  // the blocker itself
        const glm::dvec3 p = view.point(x, y);
        const glm::dvec3 towards = light.kind == scene::Light::Kind::Directional
                                       ? glm::dvec3(light.to_light)
                                       : glm::dvec3(light.position) - p;
        const double outside = distance_outside(p, towards, kHeight, kHalf);
        constexpr double kTwoTexels = 2 * 1.2 / 2048 * 1.5;  // of the widest map, at the floor
        if (outside > kTwoTexels) {
          ASSERT_EQ(mixed.x, real.x) << x << ", " << y;  // to the last bit
          if (light.kind != scene::Light::Kind::Spot) {
            ASSERT_GT(mixed.x, 0.0f);
          }
          ++lit;
        } else if (outside < -kTwoTexels) {
          ASSERT_EQ(mixed.x, 0.0f) << x << ", " << y;
          ++dark;
        }
      }
    }
    EXPECT_GT(dark, 300) << "light kind " << static_cast<int>(light.kind);
    EXPECT_GT(lit, 10000);
    EXPECT_TRUE(frame.diffuse_effect);
  }
}

// Eight suns are written out one by one in the shader: each casts its shadow. Under all of them
// there is no light left, and without any one of them there would be.
TEST(ShadowMaps, EachOfEightSunsCastsOne) {
  const FloorView view;
  const auto scene =
      floor_and(make_quad({0, 0.05f, 0}, {0.2f, 0, 0}, {0, 0, -0.2f}), scene::Role::Virtual);
  RasterRig rig(scene);
  std::vector<scene::Light> suns;
  for (int i = 0; i < 8; ++i) {
    const float angle = 0.8f * static_cast<float>(i);
    suns.push_back(make_sun({0.3f * std::cos(angle), 1.0f, 0.3f * std::sin(angle)}));
  }
  // From the side, below the blocker: it hides the floor under it from above.
  const glm::dmat4 from_the_side = look_at({0, 0.03, 0.45}, {0, 0, 0});
  const RasterFrame frame = rig.render(make_view(scene, view.camera, from_the_side, suns));
  // The floor in the middle, as far as possible from where any shadow ends.
  const auto at = common::project(view.camera, glm::dvec3(from_the_side * glm::dvec4(0, 0, 0, 1)));
  const int x = static_cast<int>(at->x), y = static_cast<int>(at->y);
  EXPECT_EQ(frame.mixed->at(x, y).w, 0.0f);  // not the blocker
  EXPECT_EQ(glm::vec3(frame.mixed->at(x, y)), glm::vec3(0.0f));
  EXPECT_GT(frame.real->at(x, y).x, 0.0f);
}

TEST(ShadowMaps, OfRealObjectsDarkenBothImagesAlike) {
  const FloorView view;
  const auto scene =
      floor_and(make_quad({0, 0.2f, 0}, {0.1f, 0, 0}, {0, 0, -0.1f}), scene::Role::Real);
  RasterRig rig(scene);
  const RasterFrame frame = rig.render(
      make_view(scene, view.camera, view.camera_from_world, {make_sun({0.6f, 1.0f, 0.35f})}, 2));
  // Numerics B19: nothing virtual, nothing changes.
  EXPECT_FALSE(frame.diffuse_effect);
  EXPECT_FALSE(frame.report("shadow maps, virtual opaque").ran);
  EXPECT_EQ(frame.report("shadow maps, virtual opaque").reason, "no virtual opaque object");
  EXPECT_FALSE(frame.report("resolve").ran);
  EXPECT_EQ(frame.report("resolve").reason, "nothing virtual has an effect on this frame");
  int dark = 0;
  for (std::size_t i = 0; i < frame.mixed->pixels().size(); ++i) {
    const glm::vec4 mixed = frame.mixed->pixels()[i], real = frame.real->pixels()[i];
    ASSERT_EQ(glm::vec3(mixed), glm::vec3(real));
    dark += mixed.x == 0.0f ? 1 : 0;
  }
  EXPECT_GT(dark, 1000);
}

TEST(ShadowMaps, GiveNoAcneOnLitSurfaces) {
  // A tilted box and a finely cut sphere, lit from low and from high: whatever faces the light and
  // is convex is lit in full, so mixed and unshadowed shading must agree.
  const common::CameraModel camera = make_pinhole(200, 150, 300.0);
  for (const glm::vec3& to_light : {glm::vec3(1.0f, 0.15f, 0.3f), glm::vec3(0.2f, 1.0f, 0.6f)}) {
    scene::Scene scene;
    add_object(scene, make_box({-0.1f, -0.1f, -0.1f}, {0.1f, 0.1f, 0.1f}),
               make_diffuse(glm::vec3(0.5f)), scene::Role::Virtual,
               glm::rotate(glm::mat4(1.0f), 0.5f, glm::normalize(glm::vec3(1, 2, 3))));
    RasterRig rig(scene);
    scene::Light sun = make_sun(to_light);
    const RasterFrame frame =
        rig.render(make_view(scene, camera, look_at({0.5, 0.35, 0.6}, {0, 0, 0}), {sun}));
    std::vector<float> values;
    for (const glm::vec4& pixel : frame.mixed->pixels()) {
      if (pixel.w > 0.0f) values.push_back(pixel.x);
    }
    std::sort(values.begin(), values.end());
    // A rough box under one sun has one value a face: three at most, 0 among them if turned away.
    const auto distinct = std::unique(values.begin(), values.end(),
                                      [](float a, float b) { return std::abs(a - b) < 1e-4f; }) -
                          values.begin();
    EXPECT_LE(distinct, 3);
    EXPECT_GT(values.size(), 3000u);
  }
}

TEST(ShadowMaps, AreKeptWhileNothingMoves) {
  const FloorView view;
  const auto scene =
      floor_and(make_quad({0, 0.2f, 0}, {0.1f, 0, 0}, {0, 0, -0.1f}), scene::Role::Virtual);
  RasterRig rig(scene);
  RenderView frame_view =
      make_view(scene, view.camera, view.camera_from_world, {make_sun({0.6f, 1.0f, 0.35f})});
  const char* const kPass = "shadow maps, virtual opaque";
  const RasterFrame first = rig.render(frame_view);
  EXPECT_TRUE(first.report(kPass).ran);

  frame_view.scene.camera_from_world = look_at({0.1, 0.9, 0.1}, {0, 0, 0});  // only the camera
  const RasterFrame second = rig.render(frame_view);
  EXPECT_FALSE(second.report(kPass).ran);
  EXPECT_EQ(second.report(kPass).reason, "nothing moved since the last frame");
  EXPECT_FALSE(second.report("upload lights").ran);

  frame_view.scene.camera_from_world = view.camera_from_world;
  const RasterFrame same = rig.render(frame_view);
  EXPECT_EQ(*same.mixed, *first.mixed);

  frame_view.scene.instances[1].world_from_mesh[3].x = 0.05f;
  const RasterFrame moved = rig.render(frame_view);
  EXPECT_TRUE(moved.report(kPass).ran);
  EXPECT_TRUE(moved.report("shadow maps, real opaque").ran);
  EXPECT_NE(*moved.mixed, *first.mixed);

  frame_view.lights[0] = make_sun({0.0f, 1.0f, 0.0f});
  EXPECT_TRUE(rig.render(frame_view).report(kPass).ran);
}

TEST(ShadowMaps, AreSmallerForMoreLights) {
  const FloorView view;
  const scene::Scene scene =
      floor_and(make_quad({0, 0.2f, 0}, {0.1f, 0, 0}, {0, 0, -0.1f}), scene::Role::Virtual);
  const auto context = shared_context();
  const gl::GpuScene gpu_scene(scene);
  const auto size_with = [&](std::size_t lights) {
    return make_shadow_layout(make_view(scene, view.camera, view.camera_from_world,
                                        std::vector<scene::Light>(lights)),
                              gpu_scene, 0)
        .size;
  };
  EXPECT_EQ(size_with(8), 2048);
  EXPECT_EQ(size_with(9), 1024);
  EXPECT_EQ(size_with(32), 1024);
  EXPECT_EQ(size_with(128), 512);
  EXPECT_EQ(size_with(129), 256);
  EXPECT_THROW(size_with(gl::kMaxLights + 1), std::runtime_error);
}

}  // namespace
}  // namespace amalgam::passes
