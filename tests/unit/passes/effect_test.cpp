#include "passes/raster/effect.h"

#include <gtest/gtest.h>

#include "support/scene_builders.h"
#include "unit/passes/raster_rig.h"

namespace amalgam::passes {
namespace {

using namespace test_support;

// I_m and I_r are both black where an unlit virtual object stands before nothing that is modelled.
// Only its coverage says that it hides what the camera sees.
TEST(EffectPass, AnUnlitBlackObjectStillCoversTheCameraImage) {
  scene::Scene scene;
  scene::Material black = make_diffuse(glm::vec3(0.0f));
  black.metallic = 1.0f;
  add_object(scene, make_box(glm::vec3(-0.1f), glm::vec3(0.1f)), black, scene::Role::Virtual);
  const RenderView view =
      make_view(scene, make_pinhole(32, 32, 32.0), look_at({0, 0, 1}, {0, 0, 0}), {});
  for (const bool leave_out_tiles : {false, true}) {
    RasterRig rig(scene);
    rig.leave_out_tiles = leave_out_tiles;
    const RasterFrame frame = rig.render(view);
    EXPECT_TRUE(frame.diffuse_effect);
    ASSERT_TRUE(frame.layers);
    EXPECT_EQ(frame.layers->at(16, 16).over, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_EQ(frame.layers->at(1, 1).over, glm::vec4(0.0f));
  }
}

TEST(EffectPass, RealObjectsAloneHaveNone) {
  scene::Scene scene;
  add_object(scene, make_floor(0.0f, 0.3f), make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  const RenderView view = make_view(scene, make_pinhole(32, 32, 32.0),
                                    look_at({0, 0.5, 0.5}, {0, 0, 0}), {make_sun({0, 1, 0})});
  RasterRig rig(scene);
  const RasterFrame frame = rig.render(view);
  EXPECT_FALSE(frame.diffuse_effect);
  EXPECT_FALSE(frame.layers);
}

}  // namespace
}  // namespace amalgam::passes
