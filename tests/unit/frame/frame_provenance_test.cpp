#include "frame/frame_provenance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "frame/default_view.h"
#include "frame/frame_renderer.h"
#include "support/scene_builders.h"

namespace amalgam::frame {
namespace {

using core::LightSource;

constexpr int kMarker = 40, kWidth = 64, kHeight = 48;

float share(const core::Provenance& shares, LightSource source) {
  return shares[static_cast<std::size_t>(source)];
}

float sum(const core::Provenance& shares) {
  return std::accumulate(shares.begin(), shares.end(), 0.0f);
}

// A real table, a virtual box and a mirror that absorbs nothing, so that all shares sum to 1.
scene::Scene make_scene() {
  scene::Scene scene;
  scene.world.marker = kMarker;
  scene.environment = scene::Environment{common::ImageRgb32f(16, 8, glm::vec3(1.0f)), false};
  test_support::add_object(scene, test_support::make_floor(0.0f, 0.12f),
                           test_support::make_diffuse(glm::vec3(0.6f)), scene::Role::Real);
  test_support::add_object(scene,
                           test_support::make_box({-0.06f, 0.001f, -0.03f}, {-0.01f, 0.04f, 0.02f}),
                           test_support::make_diffuse({0.8f, 0.3f, 0.2f}), scene::Role::Virtual);
  test_support::add_object(scene,
                           test_support::make_box({0.01f, 0.001f, -0.03f}, {0.06f, 0.05f, 0.02f}),
                           test_support::make_mirror(glm::vec3(1.0f)), scene::Role::Virtual);
  return scene;
}

core::ProvenanceImage provenance_of(RendererMode mode, const char* samples) {
  RendererSettings settings;
  settings.mode = mode;
  settings.exposure = 1.0f;
  parse_samples(samples, settings);
  FrameRenderer renderer(make_scene(), settings);
  ViewState view({.camera = common::default_camera(kWidth, kHeight),
                  .keep_pixels = true,
                  .keep_provenance = true});
  const common::ImageRgb8 image(kWidth, kHeight, common::Rgb8(120));
  return renderer.render(view, {image, {default_pose(kMarker)}}).provenance.value();
}

TEST(FrameProvenance, IsLeftOutUnlessWanted) {
  FrameRenderer renderer(make_scene(), {});
  ViewState view({.camera = common::default_camera(kWidth, kHeight), .keep_pixels = true});
  const common::ImageRgb8 image(kWidth, kHeight, common::Rgb8(120));
  EXPECT_FALSE(renderer.render(view, {image, {default_pose(kMarker)}}).provenance);
}

TEST(FrameProvenance, SharesSumToWhatOfThePixelShowsASurface) {
  for (const auto mode : {RendererMode::Hybrid, RendererMode::Raytrace}) {
    const core::ProvenanceImage image = provenance_of(mode, "4");
    int empty = 0, full = 0;
    for (const core::Provenance& shares : image.pixels()) {
      const float quarters = 4.0f * sum(shares);
      EXPECT_NEAR(quarters, std::round(quarters), 1e-5f);
      empty += sum(shares) == 0.0f ? 1 : 0;
      full += std::abs(sum(shares) - 1.0f) < 1e-5f ? 1 : 0;
    }
    EXPECT_GT(empty, 100) << "past the table";
    EXPECT_GT(full, 300);
  }
}

// What the hybrid renderer rasterises, the other one traces: virtual, or under the pixel.
TEST(FrameProvenance, RasterIsWhatTracingSeesDirectly) {
  const core::ProvenanceImage hybrid = provenance_of(RendererMode::Hybrid, "1"),
                              traced = provenance_of(RendererMode::Raytrace, "1");
  int rasterised = 0, different = 0;
  for (std::size_t i = 0; i < hybrid.pixels().size(); ++i) {
    const core::Provenance &h = hybrid.pixels()[i], &t = traced.pixels()[i];
    EXPECT_EQ(share(t, LightSource::Raster), 0.0f);
    if (share(h, LightSource::Raster) == 0.0f) continue;
    ++rasterised;
    EXPECT_EQ(share(h, LightSource::Raster), 1.0f);
    const float direct =
        std::max(share(t, LightSource::TracedVirtual), share(t, LightSource::CameraLookup));
    different += direct == 1.0f ? 0 : 1;
  }
  EXPECT_GT(rasterised, 300);
  EXPECT_LE(different, rasterised / 100) << "a silhouette through a pixel's centre";
}

// A pixel is as the first pass made it or as it was taken again; a refined one has nothing left of
// the first pass.
TEST(FrameProvenance, RefinedPixelsCountOnce) {
  const core::ProvenanceImage one = provenance_of(RendererMode::Hybrid, "1"),
                              nine = provenance_of(RendererMode::Raytrace, "9"),
                              adaptive = provenance_of(RendererMode::Hybrid, "adaptive");
  int refined = 0;
  for (std::size_t i = 0; i < adaptive.pixels().size(); ++i) {
    const core::Provenance& shares = adaptive.pixels()[i];
    if (shares == one.pixels()[i]) continue;
    ++refined;
    for (std::size_t k = 0; k < core::kLightSources; ++k) {
      EXPECT_NEAR(shares[k], nine.pixels()[i][k], 1e-5f) << i << ' ' << core::kLightSourceNames[k];
    }
  }
  EXPECT_GT(refined, 50);
  EXPECT_LT(refined, kWidth * kHeight / 2);
}

}  // namespace
}  // namespace amalgam::frame
