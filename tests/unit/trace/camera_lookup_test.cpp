#include "trace/camera_lookup.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "scene/light/tone_map.h"
#include "support/scene_builders.h"
#include "trace/add_look_ups.h"

namespace amalgam::trace {
namespace {

using test_support::add_object;

// A camera at (0, 0, 2) that looks along -z at a real wall in the plane z = 0.
class CameraLookupTest : public testing::Test {
 protected:
  CameraLookupTest() : image_(64, 48) {
    add_object(scene_, test_support::make_quad(glm::vec3(0.0f), {5, 0, 0}, {0, 5, 0}),
               test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
    view_.camera = view_.ideal = test_support::make_pinhole(64, 48, 60.0);
    view_.camera_from_world = test_support::look_at({0, 0, 2}, {0, 0, 0});
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) image_.at(x, y) = common::Rgb8(4 * x, 5 * y, 100);
    }
  }

  std::optional<CameraPlace> look_up(const glm::vec3& position, const glm::vec3& normal) {
    EmbreeScene embree(scene_);
    scene::AnchoredScene anchored;
    for (std::uint32_t i = 0; i < scene_.instances.size(); ++i) {
      anchored.instances.push_back({i, scene_.instances[i].anchor_from_mesh});
    }
    embree.place(anchored);
    SurfacePoint point;
    point.position = point.inside = position;
    point.geometric_normal = normal;
    point.offset = offset_height(5.0f);  // the wall's
    return CameraLookup(view_).find(embree, point, lookup_rays_);
  }

  scene::Scene scene_;
  common::ImageRgb8 image_;
  CameraView view_;
  std::uint64_t lookup_rays_ = 0;
};

constexpr glm::vec3 kTowards(0, 0, 1);

TEST_F(CameraLookupTest, ReturnsTheCamerasOwnColor) {
  // One pixel right of and two below the principal point: 2 m / 60 px each.
  const glm::vec3 position(1.0f * 2 / 60, -2.0f * 2 / 60, 0.0f);
  const auto seen = look_up(position, kTowards);
  ASSERT_TRUE(seen);
  EXPECT_FLOAT_EQ(seen->trust, 1.0f);
  const float exposure = 0.7f;
  const glm::vec3 shown =
      scene::tone_map(camera_radiance(image_, seen->pixel, scene::tone_map_of(exposure)),
                      scene::tone_map_of(exposure));
  const auto at = common::project(view_.camera,
                                  glm::dvec3(view_.camera_from_world * glm::dvec4(position, 1.0)));
  ASSERT_TRUE(at);
  // The image is a ramp in bytes; between two pixels the value lies between theirs.
  EXPECT_GE(shown.x,
            scene::srgb_decode(static_cast<std::uint8_t>(4 * static_cast<int>(at->x))) - 1e-5f);
  EXPECT_LE(shown.x,
            scene::srgb_decode(static_cast<std::uint8_t>(4 * static_cast<int>(at->x) + 4)) + 1e-5f);
}

// numerics A1, B15: nothing behind, at or beside the camera is found.
TEST_F(CameraLookupTest, NothingOutsideTheViewIsFound) {
  for (const glm::vec3& position : {glm::vec3(0, 0, 4), glm::vec3(0, 0, 2), glm::vec3(3, 0, 2),
                                    glm::vec3(0.01f, 0.01f, 3.0f), glm::vec3(4, 0, 0)}) {
    EXPECT_FALSE(look_up(position, kTowards)) << position.x << " " << position.z;
    EXPECT_FALSE(look_up(position, -kTowards)) << position.x << " " << position.z;
  }
}

TEST_F(CameraLookupTest, WhatIsHiddenByARealObjectIsNotFound) {
  add_object(scene_, test_support::make_quad({0, 0, 1}, {0.1f, 0, 0}, {0, 0.1f, 0}),
             test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  EXPECT_FALSE(look_up({0, 0, 0}, kTowards));
  EXPECT_EQ(lookup_rays_, 1u);
  EXPECT_TRUE(look_up({0.4f, 0, 0}, kTowards));
}

// Two layers of gauze, of which nothing is there; then a solid one behind them.
TEST_F(CameraLookupTest, MaskedOutTexelsHideNothing) {
  scene::Material gauze = test_support::make_diffuse(glm::vec3(0.5f));
  gauze.base_color.a = 0.25f;
  gauze.alpha_cutoff = 0.5f;
  for (const float z : {0.5f, 1.0f}) {
    add_object(scene_, test_support::make_quad({0, 0, z}, {0.1f, 0, 0}, {0, 0.1f, 0}), gauze,
               scene::Role::Real);
  }
  EXPECT_TRUE(look_up({0.01f, 0.02f, 0}, kTowards));
  gauze.base_color.a = 0.75f;
  add_object(scene_, test_support::make_quad({0, 0, 1.5f}, {0.1f, 0, 0}, {0, 0.1f, 0}), gauze,
             scene::Role::Real);
  EXPECT_FALSE(look_up({0.01f, 0.02f, 0}, kTowards));
}

TEST_F(CameraLookupTest, AVirtualObjectHidesNothingFromTheCamera) {
  add_object(scene_, test_support::make_quad({0, 0, 1}, {0.1f, 0, 0}, {0, 0.1f, 0}),
             test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Virtual);
  EXPECT_TRUE(look_up({0, 0, 0}, kTowards));
}

TEST_F(CameraLookupTest, TheBackOfAThinWallIsNotWhatTheCameraSees) {
  EXPECT_FALSE(look_up({0, 0, 0}, -kTowards));
}

TEST_F(CameraLookupTest, TrustFallsTowardsTheBorder) {
  const float border = 0.5f * 64 / 60 * 2;  // metres from the axis on the wall
  const auto inner = look_up({border - 0.04f, 0, 0}, kTowards);
  ASSERT_TRUE(inner);
  EXPECT_LT(inner->trust, 1.0f);
}

TEST_F(CameraLookupTest, DepthDecidesWithoutRays) {
  common::Image32f depth(64, 48, 2.0f);
  view_.real_depth = &depth;
  EXPECT_TRUE(look_up({0, 0, 0}, kTowards));
  EXPECT_EQ(lookup_rays_, 0u);
  depth = common::Image32f(64, 48, 1.0f);
  EXPECT_FALSE(look_up({0, 0, 0}, kTowards));
  EXPECT_EQ(lookup_rays_, 0u);
  depth.at(32, 24) = 2.0f;  // an edge next to the point: only a ray can tell
  EXPECT_TRUE(look_up({0, 0, 0}, kTowards));
  EXPECT_EQ(lookup_rays_, 1u);
}

}  // namespace
}  // namespace amalgam::trace
