// What may be sent back before anything is drawn, and what must not.
#include "frame/nothing_in_view.h"

#include <gtest/gtest.h>

#include "support/scene_builders.h"

namespace amalgam::frame {
namespace {

using test_support::add_object;

// A camera half a metre above the origin that looks straight down on a real floor, so that its
// picture covers x and z within 0.25 m.
class NothingInView : public testing::Test {
 protected:
  NothingInView() {
    add_object(scene_, test_support::make_floor(0.0f, 2.0f),
               test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  }

  void add_box(const glm::vec3& low, const glm::vec3& high) {
    add_object(scene_, test_support::make_box(low, high),
               test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Virtual);
  }

  bool is_nothing(const std::vector<scene::Light>& lights) const {
    passes::RenderView view;
    view.camera = {.width = 100, .height = 100, .fx = 100.0, .fy = 100.0, .cx = 49.5, .cy = 49.5};
    view.ideal = view.camera;
    // x right; y down in the camera is +z; forward is -y.
    view.scene.camera_from_world = glm::dmat4(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0.5, 1);
    for (std::uint32_t i = 0; i < scene_.instances.size(); ++i)
      view.scene.instances.push_back({i, glm::mat4(1.0f)});
    view.lights = lights;
    const auto bounds = scene::mesh_bounds(scene_);
    return nothing_virtual_in_view(scene_, bounds, view);
  }

  scene::Scene scene_;
};

scene::Light lamp(const glm::vec3& position) {
  scene::Light light;
  light.kind = scene::Light::Kind::Point;
  light.position = position;
  light.intensity = glm::vec3(1.0f);
  return light;
}

TEST_F(NothingInView, BesideTheViewOnlyIfItsShadowIsToo) {
  add_box({0.5f, 0.0f, -0.05f}, {0.6f, 0.1f, 0.05f});
  EXPECT_TRUE(is_nothing({test_support::make_sun({0, 1, 0})}));
  EXPECT_TRUE(is_nothing({test_support::make_sun({-1, 1, 0})})) << "the shadow falls away";
  EXPECT_FALSE(is_nothing({test_support::make_sun({5, 1, 0})})) << "the low sun throws it in";
  EXPECT_FALSE(is_nothing({test_support::make_sun({0, 1, 0}), test_support::make_sun({5, 1, 0})}))
      << "any light is enough";
}

TEST_F(NothingInView, LampsThrowShadowsTowardsOrAway) {
  add_box({0.5f, 0.0f, -0.05f}, {0.6f, 0.1f, 0.05f});
  EXPECT_TRUE(is_nothing({lamp({0.0f, 0.3f, 0.0f})}));
  EXPECT_FALSE(is_nothing({lamp({0.8f, 0.12f, 0.0f})}));
  EXPECT_FALSE(is_nothing({lamp({0.55f, 0.05f, 0.0f})})) << "a lamp in the box shades everything";
}

TEST_F(NothingInView, InViewIsInView) {
  add_box({0.2f, 0.0f, 0.2f}, {0.6f, 0.1f, 0.6f});
  EXPECT_FALSE(is_nothing({}));
}

TEST_F(NothingInView, BehindTheCameraItStillShades) {
  add_box({-0.05f, 0.6f, -0.05f}, {0.05f, 0.7f, 0.05f});
  EXPECT_FALSE(is_nothing({test_support::make_sun({0, 1, 0})}));
  EXPECT_TRUE(is_nothing({test_support::make_sun({1, 0.2f, 0})})) << "its shadow falls far off";
}

TEST_F(NothingInView, ARealMirrorMayShowIt) {
  add_box({0.5f, 0.0f, -0.05f}, {0.6f, 0.1f, 0.05f});
  add_object(scene_, test_support::make_floor(0.01f, 0.1f), test_support::make_mirror(),
             scene::Role::Real);
  EXPECT_FALSE(is_nothing({test_support::make_sun({0, 1, 0})}));
}

}  // namespace
}  // namespace amalgam::frame
