#include "passes/raster/mask.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "support/scene_builders.h"
#include "unit/passes/raster_rig.h"

namespace amalgam::passes {
namespace {

using namespace test_support;
constexpr std::uint8_t kVirtual = SampleMask::kVirtual, kSpecular = SampleMask::kSpecular,
                       kSurface = SampleMask::kSurface;

double edge(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
  const glm::dvec2 along = glm::normalize(b - a);
  return along.x * (p.y - a.y) - along.y * (p.x - a.x);  // signed distance in pixels
}

// Every sample is inside or outside as the formula for its place says: the right way up, centred on
// integers, and sample i of n at x - 1/2 + (i + 1/2) / n.
TEST(MaskPass, CoversTheSamplesThatTheCameraModelSays) {
  common::CameraModel camera = make_pinhole(40, 30, 50.0);
  camera.fy = 47.0;
  camera.cx = 17.3;  // nothing about it is symmetric
  camera.cy = 12.9;
  scene::Mesh triangle;
  triangle.positions = {{-0.18f, 0.11f, 0.0f}, {0.23f, 0.17f, 0.1f}, {0.02f, -0.16f, -0.1f}};
  triangle.normals.assign(3, {0.0f, 0.0f, 1.0f});
  triangle.triangles = {{0, 1, 2}};
  scene::Scene scene;
  add_object(scene, triangle, make_diffuse(glm::vec3(0.5f)), scene::Role::Virtual);
  const glm::dmat4 camera_from_world = look_at({0.05, 0.04, 0.6}, {0.01, 0.0, 0.0});

  std::array<glm::dvec2, 3> corners{};
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 p(camera_from_world * glm::dvec4(glm::dvec3(triangle.positions[i]), 1.0));
    corners[i] = common::project(camera, p).value();
  }
  RasterRig rig(scene);
  for (const int n : {1, 2, 4}) {
    const RasterFrame frame = rig.render(make_view(scene, camera, camera_from_world, {}, n));
    ASSERT_EQ(frame.mask->flags.size(), glm::ivec2(40 * n, 30 * n));
    int inside_count = 0;
    for (int y = 0; y < 30 * n; ++y) {
      for (int x = 0; x < 40 * n; ++x) {
        const glm::dvec2 at((x + 0.5) / n - 0.5, (y + 0.5) / n - 0.5);
        std::array<double, 3> distance{};
        for (std::size_t i = 0; i < 3; ++i)
          distance[i] = edge(corners[i], corners[(i + 1) % 3], at);
        // GL snaps corners to 1/256 pixel of the sample grid.
        const double smallest =
            std::min({std::abs(distance[0]), std::abs(distance[1]), std::abs(distance[2])});
        if (smallest < 0.01) continue;
        const bool inside =
            (distance[0] > 0) == (distance[1] > 0) && (distance[1] > 0) == (distance[2] > 0);
        inside_count += inside ? 1 : 0;
        ASSERT_EQ(frame.mask->flags.at(x, y), inside ? kVirtual | kSurface : 0)
            << x << ", " << y << " of " << n;
      }
    }
    EXPECT_GT(inside_count, 100 * n * n);
  }
}

TEST(MaskPass, ShowsTheNearestSurfaceWhateverTheOrder) {
  // Seen from above: a real floor, a virtual mirror over its left half, a real box over the
  // mirror's left half.
  scene::Scene scene;
  add_object(scene, make_box({-1.0f, 0.2f, -1.0f}, {-0.5f, 0.3f, 1.0f}),
             make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  add_object(scene, make_floor(0.0f, 1.0f), make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  add_object(scene, make_quad({-0.5f, 0.1f, 0.0f}, {0.5f, 0, 0}, {0, 0, -1.0f}), make_mirror(),
             scene::Role::Virtual);
  RasterRig rig(scene);
  const common::CameraModel camera = make_pinhole(64, 64, 32.0);  // the floor fills it from 1 m
  const RasterFrame frame =
      rig.render(make_view(scene, camera, look_at({0, 1, 0}, {0, 0, 0}, {0, 0, -1}), {}));
  EXPECT_EQ(frame.mask->flags.at(2, 32), kSurface);
  EXPECT_EQ(frame.mask->flags.at(26, 32), kSurface | kVirtual | kSpecular);
  EXPECT_EQ(frame.mask->flags.at(48, 32), kSurface);
  EXPECT_EQ(frame.counts->total, 64u * 64u);
  EXPECT_EQ(frame.counts->surface, 64u * 64u);
  EXPECT_EQ(frame.counts->specular, frame.counts->virtual_surface);
  EXPECT_GT(frame.counts->specular, 0u);
  EXPECT_TRUE(frame.report("diffuse").ran);
}

TEST(MaskPass, LeavesHolesWhereTheTextureIsTransparent) {
  scene::Scene scene;
  scene::Texture texture;
  texture.texels = common::ImageRgba8(2, 1, {255, 255, 255, 255});
  texture.texels.at(0, 0).w = 0;
  texture.wrap_u = texture.wrap_v = scene::Wrap::Clamp;
  scene.textures.push_back(texture);
  scene::Material material = make_diffuse(glm::vec3(1.0f));
  material.base_color_texture = 0;
  material.alpha_cutoff = 0.5f;
  add_object(scene, make_floor(0.0f, 1.0f), material, scene::Role::Virtual);
  RasterRig rig(scene);
  const RasterFrame frame = rig.render(
      make_view(scene, make_pinhole(64, 64, 32.0), look_at({0, 1, 0}, {0, 0, 0}, {0, 0, -1}), {}));
  EXPECT_EQ(frame.mask->flags.at(20, 32), 0);
  EXPECT_EQ(frame.mask->flags.at(44, 32), kSurface | kVirtual);
  EXPECT_EQ(frame.mixed->at(20, 32), glm::vec4(0.0f));
}

TEST(MaskPass, SaysWhatIsNotInView) {
  scene::Scene scene;
  add_object(scene, make_floor(0.0f, 1.0f), make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  add_object(scene, make_sphere({0, 0.1f, 0}, 0.1f), make_mirror(), scene::Role::Virtual);
  RasterRig rig(scene);
  const common::CameraModel camera = make_pinhole(32, 32, 32.0);
  const auto lights = {make_sun({0, 1, 0})};
  // Away from everything.
  const RasterFrame away =
      rig.render(make_view(scene, camera, look_at({0, 1, 0}, {0, 2, 0}, {0, 0, 1}), lights));
  EXPECT_EQ(away.counts->surface, 0u);
  for (const char* pass : {"diffuse", "effect", "resolve", "upload lights",
                           "shadow maps, real opaque", "shadow maps, virtual opaque"}) {
    EXPECT_FALSE(away.report(pass).ran) << pass;
    EXPECT_EQ(away.report(pass).reason, "no diffuse object in view") << pass;
  }
  EXPECT_EQ(away.report("real depth").reason, "no specular pixel in this frame");
  // Nothing but the mirror.
  const RasterFrame mirror =
      rig.render(make_view(scene, camera, look_at({0, 0.25, 0}, {0, 0, 0}, {0, 0, 1}), lights));
  EXPECT_EQ(mirror.counts->specular, mirror.counts->total);
  EXPECT_EQ(mirror.report("diffuse").reason, "no diffuse object in view");
  EXPECT_TRUE(mirror.report("real depth").ran);
}

}  // namespace
}  // namespace amalgam::passes
