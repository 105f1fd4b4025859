// Virtual things in fewer pixels than the camera's, and frames that choose how many by themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "codec/jpeg.h"
#include "frame/default_view.h"
#include "frame/frame_renderer.h"
#include "support/scene_builders.h"

namespace amalgam::frame {
namespace {

using test_support::add_object;

constexpr int kMarker = 40, kWidth = 160, kHeight = 120;

scene::Scene empty_table() {
  scene::Scene scene;
  scene.world.marker = kMarker;
  scene.environment = scene::Environment{common::ImageRgb32f(16, 8, glm::vec3(1.0f)), false};
  add_object(scene, test_support::make_floor(0.0f, 0.5f),
             test_support::make_diffuse(glm::vec3(0.6f)), scene::Role::Real);
  return scene;
}

// Fills the picture's middle and reaches beyond its lower edge.
scene::Scene table_with_quad() {
  scene::Scene scene = empty_table();
  add_object(
      scene,
      test_support::make_quad({0.0f, 0.001f, 0.15f}, {0.06f, 0.0f, 0.0f}, {0.0f, 0.0f, -0.2f}),
      test_support::make_diffuse(glm::vec3(0.2f, 0.5f, 0.3f)), scene::Role::Virtual);
  return scene;
}

scene::Scene table_with_glass_ball() {
  scene::Scene scene = empty_table();
  add_object(scene, test_support::make_sphere({0.0f, 0.03f, 0.0f}, 0.03f),
             test_support::make_glass(), scene::Role::Virtual);
  return scene;
}

common::ImageRgb8 stripes() {
  common::ImageRgb8 image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) image.at(x, y) = common::Rgb8(90 + x, 200 - y, x / 8 % 2 * 60);
  }
  return image;
}

RendererSettings scaled(float scale) {
  RendererSettings settings;
  settings.render_scale = scale;
  settings.exposure = 0.8f;
  return settings;
}

common::CameraModel distorting_camera() {
  common::CameraModel camera = common::default_camera(kWidth, kHeight);
  camera.distortion = {0.1, -0.2, 0.0075, 0.0034, 0.0};
  return camera;
}

FrameOutput render(const scene::Scene& scene, const RendererSettings& settings,
                   const common::CameraModel& camera = common::default_camera(kWidth, kHeight)) {
  FrameRenderer renderer(scene, settings);
  ViewState view({.camera = camera, .keep_pixels = true});
  return renderer.render(view, {codec::encode_jpeg(stripes(), 90), {default_pose(kMarker)}});
}

const PassRecord* find_pass(const FrameOutput& output, const std::string& name) {
  const auto& passes = output.statistics.passes;
  const auto found = std::find_if(passes.begin(), passes.end(),
                                  [&](const PassRecord& record) { return record.name == name; });
  return found != passes.end() ? &*found : nullptr;
}

struct Difference {
  double mean = 0.0;
  int far = 0;  // pixels off by more than 8 bytes
};
Difference difference(const common::ImageRgb8& a, const common::ImageRgb8& b) {
  Difference result;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const glm::ivec3 d = glm::abs(glm::ivec3(a.pixels()[i]) - glm::ivec3(b.pixels()[i]));
    result.mean += (d.x + d.y + d.z) / (3.0 * static_cast<double>(a.pixels().size()));
    if (std::max({d.x, d.y, d.z}) > 8) ++result.far;
  }
  return result;
}

TEST(RenderScale, OneIsAsIfItWereNotThere) {
  const FrameOutput plain = render(table_with_glass_ball(), scaled(1.0f));
  EXPECT_EQ(find_pass(plain, "warp")->reason, "the lens does not distort");
  EXPECT_EQ(plain.statistics.pixels.total, static_cast<std::uint64_t>(kWidth) * kHeight);
}

// A plain surface is the same in half the pixels, but for its outline; up to the picture's own
// edge, which the quad crosses.
TEST(RenderScale, APlainQuadLooksTheSame) {
  for (const common::CameraModel& camera :
       {common::default_camera(kWidth, kHeight), distorting_camera()}) {
    const FrameOutput full = render(table_with_quad(), scaled(1.0f), camera);
    for (const float scale : {0.5f, 0.7f, 0.85f}) {
      const FrameOutput less = render(table_with_quad(), scaled(scale), camera);
      EXPECT_LT(less.statistics.pixels.virtual_pixels, full.statistics.pixels.virtual_pixels);
      const auto [mean, far] = difference(full.pixels, less.pixels);
      // The outline is some 250 pixels long, and is smeared over less than one of the pixels that
      // are rendered; all else is the same.
      EXPECT_LT(far, 250 / static_cast<double>(scale)) << scale;
      EXPECT_LT(mean, 0.25 / static_cast<double>(scale)) << scale;
      for (int x = 70; x < 90; ++x) {
        const glm::ivec3 d = glm::abs(glm::ivec3(full.pixels.at(x, kHeight - 1)) -
                                      glm::ivec3(less.pixels.at(x, kHeight - 1)));
        EXPECT_LE(std::max({d.x, d.y, d.z}), 2) << "the last row, at " << x;
      }
    }
  }
}

// Look-ups are by the real camera: what glass shows of the table is in its place.
TEST(RenderScale, GlassShowsTheSameTable) {
  const common::ImageRgb8 camera = stripes();
  const FrameOutput full = render(table_with_glass_ball(), scaled(1.0f)),
                    half = render(table_with_glass_ball(), scaled(0.5f));
  EXPECT_LT(half.statistics.rays.refraction, full.statistics.rays.refraction / 3);
  EXPECT_LT(difference(full.pixels, half.pixels).mean, 0.15 * difference(full.pixels, camera).mean);
}

TEST(RenderScale, PixelsThatNothingTouchesKeepTheirBytes) {
  const FrameOutput half = render(table_with_glass_ball(), scaled(0.5f));
  const common::ImageRgb8 camera = codec::decode_jpeg(codec::encode_jpeg(stripes(), 90));
  EXPECT_EQ(half.pixels.at(0, 0), camera.at(0, 0));
  EXPECT_EQ(half.pixels.at(kWidth - 1, 0), camera.at(kWidth - 1, 0));
}

TEST(RenderScale, NothingVirtualGivesTheClientsBytes) {
  FrameRenderer renderer(empty_table(), scaled(0.5f));
  ViewState view({.camera = common::default_camera(kWidth, kHeight)});
  const Bytes jpeg = codec::encode_jpeg(stripes(), 90);
  const FrameOutput output = renderer.render(view, {jpeg, {default_pose(kMarker)}});
  EXPECT_TRUE(output.unchanged);
  EXPECT_EQ(output.jpeg, jpeg);
}

TEST(RenderScale, SameBitsForAnyNumberOfThreads) {
  RendererSettings settings = scaled(0.7f);
  settings.threads = 1;
  const FrameOutput one = render(table_with_glass_ball(), settings);
  settings.threads = 3;
  EXPECT_EQ(render(table_with_glass_ball(), settings).jpeg, one.jpeg);
}

// An impossible target ends at the lowest level, view by view, and the next frame is made with what
// the last one's statistics led to.
TEST(TargetFps, FramesSayWhatWasChosen) {
  EXPECT_FALSE(render(table_with_glass_ball(), scaled(1.0f)).statistics.quality);
  RendererSettings settings = scaled(1.0f);
  settings.target_fps = 1000.0;
  settings.coarse_allowed = true;
  FrameRenderer renderer(table_with_glass_ball(), settings);
  ViewState view({.camera = common::default_camera(kWidth, kHeight)});
  const FrameInput input{codec::encode_jpeg(stripes(), 90), {default_pose(kMarker)}};
  const FrameOutput first = renderer.render(view, input);
  ASSERT_TRUE(first.statistics.quality);
  EXPECT_EQ(first.statistics.quality->level, 0);
  EXPECT_EQ(first.statistics.quality->bound, FrameQuality::Bound::Nothing);
  FrameOutput last;
  for (int i = 0; i < 4; ++i) last = renderer.render(view, input);
  EXPECT_EQ(last.statistics.quality->bound, FrameQuality::Bound::Lowest);
  EXPECT_EQ(last.statistics.quality->render_scale, 0.5f);
  EXPECT_TRUE(find_pass(last, "warp")->ran);
  EXPECT_LT(last.statistics.pixels.total, first.statistics.pixels.total / 3);

  ViewState other({.camera = common::default_camera(kWidth, kHeight)});
  EXPECT_EQ(renderer.render(other, input).statistics.quality->level, 0);
}

// A frame without anything virtual is quick whatever the quality; that is no reason to raise it.
TEST(TargetFps, UnaffectedFramesChangeNothing) {
  RendererSettings settings = scaled(1.0f);
  settings.target_fps = 1000.0;
  settings.coarse_allowed = true;
  FrameRenderer renderer(table_with_glass_ball(), settings);
  ViewState view({.camera = common::default_camera(kWidth, kHeight)});
  const Bytes jpeg = codec::encode_jpeg(stripes(), 90);
  for (int i = 0; i < 4; ++i) renderer.render(view, {jpeg, {default_pose(kMarker)}});
  const int level = view.governor->report().level;
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(renderer.render(view, {jpeg, {}}).unchanged);
  EXPECT_EQ(view.governor->report().level, level);
}

}  // namespace
}  // namespace amalgam::frame
