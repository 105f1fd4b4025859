#include "passes/raster/resolve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "scene/light/tone_map.h"
#include "support/scene_builders.h"
#include "unit/passes/raster_rig.h"

namespace amalgam::passes {
namespace {

using namespace test_support;

struct Desk {
  scene::Scene scene;
  common::CameraModel camera = make_pinhole(60, 45, 60.0);
  glm::dmat4 camera_from_world = look_at({0.1, 0.5, 0.4}, {0.0, 0.0, 0.0});
  Desk() {
    add_object(scene, make_floor(0.0f, 0.3f), make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
    add_object(scene, make_box({-0.05f, 0.0f, -0.05f}, {0.05f, 0.1f, 0.05f}),
               make_diffuse({0.9f, 0.4f, 0.1f}), scene::Role::Virtual);
    add_object(scene, make_sphere({0.12f, 0.05f, 0.05f}, 0.05f), make_mirror(),
               scene::Role::Virtual);
  }
  RenderView view(int n) const {
    return make_view(scene, camera, camera_from_world,
                     {make_sun({0.6f, 1.0f, 0.3f}), make_sun({-0.5f, 1.0f, 0.4f})}, n);
  }
};

// The layers of one pixel by eq. 4.5 from the samples, on the CPU.
struct Expected {
  glm::vec4 over{0.0f};
  glm::vec3 difference{0.0f};
};
Expected resolve(const RasterFrame& frame, int x, int y, int n, float exposure) {
  Expected sum;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const glm::vec4 mixed = frame.mixed->at(x * n + i, y * n + j);
      const glm::vec3 tm = scene::tone_map(glm::vec3(mixed), scene::tone_map_of(exposure));
      const glm::vec3 tr = scene::tone_map(glm::vec3(frame.real->at(x * n + i, y * n + j)),
                                           scene::tone_map_of(exposure));
      if (mixed.w > 0.0f) {
        sum.over += glm::vec4(tm, 1.0f);
      } else {
        sum.difference += tm - tr;
      }
    }
  }
  const float weight = 1.0f / static_cast<float>(n * n);
  return {sum.over * weight, sum.difference * weight};
}

TEST(ResolvePass, AveragesTheSamplesOfAPixel) {
  const Desk desk;
  RasterRig rig(desk.scene);
  for (const int n : {1, 2, 3, 4}) {
    const float exposure = 0.7f;
    const RasterFrame frame = rig.render(desk.view(n), exposure);
    ASSERT_TRUE(frame.layers);
    ASSERT_EQ(frame.layers->size(), glm::ivec2(60, 45));
    int partly = 0;
    for (int y = 0; y < 45; ++y) {
      for (int x = 0; x < 60; ++x) {
        const Expected expected = resolve(frame, x, y, n, exposure);
        ASSERT_LT(glm::distance(frame.layers->at(x, y).over, expected.over), 1e-6f);
        ASSERT_LT(glm::distance(frame.layers->at(x, y).difference, expected.difference), 1e-6f);
        const float coverage = frame.layers->at(x, y).over.w;
        partly += coverage > 0.0f && coverage < 1.0f ? 1 : 0;
      }
    }
    EXPECT_EQ(partly > 0, n > 1);
    EXPECT_EQ(frame.nonfinite, 0u);
  }
}

// By ratio, a shadow is a factor on the light: the model's color does not matter, and pixels that a
// virtual object covers in part keep the ratio of the rest.
TEST(ResolvePass, TakesRealSurfacesByTheRatioOfTheirLight) {
  Desk desk;
  const auto render = [&](const glm::vec3& floor, int n) {
    desk.scene.materials[desk.scene.instances[0].material].base_color = glm::vec4(floor, 1.0f);
    RasterRig rig(desk.scene);
    return rig.render(desk.view(n), 0.7f, scene::RealSurfaces::Ratio);
  };
  for (const int n : {1, 3}) {
    const RasterFrame grey = render(glm::vec3(0.5f), n);
    const RasterFrame red = render({0.9f, 0.2f, 0.1f}, n);
    int shadowed = 0;
    for (int y = 0; y < 45; ++y) {
      for (int x = 0; x < 60; ++x) {
        const core::LayerPixel pixel = grey.layers->at(x, y);
        ASSERT_EQ(pixel.difference, glm::vec3(0.0f));
        // Highlights of the floor are not of its color.
        ASSERT_LT(glm::distance(pixel.relative_change, red.layers->at(x, y).relative_change),
                  0.06f);
        glm::vec3 sum(0.0f);
        for (int j = 0; j < n; ++j) {
          for (int i = 0; i < n; ++i) {
            const glm::vec4 mixed = grey.mixed->at(x * n + i, y * n + j);
            const glm::vec4 real = grey.real->at(x * n + i, y * n + j);
            if (real.w > 0.0f) sum += glm::vec3(mixed) / glm::vec3(real) - 1.0f;
          }
        }
        sum /= static_cast<float>(n * n);
        ASSERT_LT(glm::distance(pixel.relative_change, sum), 1e-5f);
        shadowed += sum.x < 0.0f ? 1 : 0;
        ASSERT_LE(pixel.light_ratio().x, 1.0f);
      }
    }
    EXPECT_GT(shadowed, 50);
  }
}

// Numerics B19 within a frame: what nothing virtual reaches has a difference of exactly 0.
TEST(ResolvePass, ChangesNothingOutOfReachOfVirtualObjects) {
  const Desk desk;
  RasterRig rig(desk.scene);
  const RasterFrame frame = rig.render(desk.view(2), 1.3f);
  EXPECT_TRUE(frame.diffuse_effect);
  int untouched = 0, shadowed = 0;
  for (int y = 0; y < 45; ++y) {
    for (int x = 0; x < 60; ++x) {
      const glm::vec3 difference = frame.layers->at(x, y).difference;
      untouched += difference == glm::vec3(0.0f) ? 1 : 0;
      shadowed += difference.x < 0.0f ? 1 : 0;
      ASSERT_LE(difference.x, 0.0f);  // only shadows here
    }
  }
  EXPECT_GT(shadowed, 50);
  EXPECT_GT(untouched, 1000);
  EXPECT_EQ(untouched + shadowed, 60 * 45);
}

// Specular samples are the tracer's: the rasteriser adds nothing there.
TEST(ResolvePass, IsZeroOnSpecularSamples) {
  const Desk desk;
  RasterRig rig(desk.scene);
  const RasterFrame frame = rig.render(desk.view(1));
  int specular = 0;
  for (int y = 0; y < 45; ++y) {
    for (int x = 0; x < 60; ++x) {
      if ((frame.mask->flags.at(x, y) & SampleMask::kSpecular) == 0) continue;
      ++specular;
      ASSERT_EQ(frame.layers->at(x, y).over, glm::vec4(0.0f));
      ASSERT_EQ(frame.layers->at(x, y).difference, glm::vec3(0.0f));
    }
  }
  EXPECT_GT(specular, 20);
}

// Equal geometry, so equal averages: 4 x 4 samples over a plain surface give what one gives.
TEST(ResolvePass, GivesTheSameAveragesForAnyNumberOfSamples) {
  scene::Scene scene;
  add_object(scene, make_floor(0.0f, 2.0f), make_diffuse({0.9f, 0.4f, 0.1f}), scene::Role::Virtual);
  RasterRig rig(scene);
  const Desk desk;
  const auto render = [&](int n) {
    return *rig.render(make_view(scene, desk.camera, desk.camera_from_world,
                                 {make_sun({0.6f, 1.0f, 0.3f})}, n))
                .layers;
  };
  const Layers one = render(1);
  for (const int n : {2, 4}) {
    const Layers more = render(n);
    const common::ImageRgba32f one_over = one.over_image(), more_over = more.over_image();
    for (std::size_t i = 0; i < one_over.pixels().size(); ++i) {
      ASSERT_LT(glm::distance(one_over.pixels()[i], more_over.pixels()[i]), 1e-6f);
    }
  }
}

// Numerics B17 and A5: no infinity or NaN leaves the stage.
TEST(ResolvePass, ReplacesWhatIsNotFinite) {
  Desk desk;
  RasterRig rig(desk.scene);
  RenderView view = desk.view(2);
  view.lights[0].intensity = glm::vec3(std::numeric_limits<float>::infinity(), 1.0f, 3e38f);
  view.lights[1].intensity = glm::vec3(std::numeric_limits<float>::quiet_NaN(), 1.0f, 1.0f);
  const RasterFrame frame = rig.render(view);
  EXPECT_GT(frame.nonfinite, 0u);
  const common::ImageRgba32f over = frame.layers->over_image();
  const common::ImageRgb32f difference = frame.layers->difference_image();
  for (const glm::vec4& pixel : over.pixels()) {
    for (int i = 0; i < 4; ++i) ASSERT_TRUE(std::isfinite(pixel[i]));
  }
  for (const glm::vec3& pixel : difference.pixels()) {
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(std::isfinite(pixel[i]));
  }
}

TEST(EffectPass, SeesAShadowOfWhatIsNotInView) {
  scene::Scene scene;
  add_object(scene, make_floor(0.0f, 1.0f), make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  add_object(scene, make_box({-0.05f, 0.5f, -0.05f}, {0.05f, 0.55f, 0.05f}),
             make_diffuse(glm::vec3(0.5f)), scene::Role::Virtual);
  RasterRig rig(scene);
  const common::CameraModel camera = make_pinhole(32, 32, 64.0);
  const glm::dmat4 below = look_at({0.0, 0.3, 0.05}, {0.0, 0.0, 0.0});
  const RasterFrame shadow = rig.render(make_view(scene, camera, below, {make_sun({0, 1, 0})}));
  EXPECT_EQ(shadow.counts->virtual_surface, 0u);
  EXPECT_TRUE(shadow.diffuse_effect);
  // The same with the shadow elsewhere.
  const RasterFrame none = rig.render(make_view(scene, camera, below, {make_sun({1, 1, 0})}));
  EXPECT_FALSE(none.diffuse_effect);
  EXPECT_TRUE(none.report("effect").ran);
  EXPECT_FALSE(none.report("resolve").ran);
  EXPECT_EQ(none.report("resolve").reason, "nothing virtual has an effect on this frame");
}

}  // namespace
}  // namespace amalgam::passes
