// A camera that looks at a printed marker on a desk: what it shows is known in closed form.
#include "passes/image/paper_meter.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>

#include "support/scene_builders.h"

namespace amalgam::passes {
namespace {

using scene::ToneCurve;

// Looks straight down at a marker of 5 cm from 20 cm above: 60 pixels wide.
struct Desk {
  int width = 160, height = 120;
  common::CameraModel camera = test_support::make_pinhole(width, height, 240.0);
  common::MarkerPose pose{40, {1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.2}};  // x right, y up
  glm::vec3 desk{0.4f, 0.05f, 0.04f};                                  // reflectance
  glm::vec3 light{0.5f};  // W: what a white desk would send back
  ToneCurve curve = ToneCurve::Reinhard;
  glm::vec3 exposure{1.0f};
  float paper = kPaper, ink = kInk;

  // The left half of the marker is black, its right half and margin are white.
  common::ImageRgb8 image() const {
    common::ImageRgb8 image(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const glm::dvec2 at = glm::dvec2(x - camera.cx, y - camera.cy) * (0.2 / 240.0);
        const double out = std::max(std::abs(at.x), std::abs(at.y));
        glm::vec3 reflectance = desk;
        if (out < 0.0375) reflectance = glm::vec3(paper);
        if (out < 0.025 && at.x < 0.0) reflectance = glm::vec3(ink);
        image.at(x, y) =
            scene::srgb_encode(scene::tone_map(reflectance * light, {exposure, curve}));
      }
    }
    return image;
  }
  MeterGrid grid() const {
    return {.real = {},
            .white = common::ImageRgba32f(width / 4, height / 4, glm::vec4(light, 1.0f)),
            .step = 4,
            .samples_per_side = 1};
  }
  std::vector<PaperSample> samples() const {
    return sample_paper(grid(), {{&pose, 1}, 0.05}, camera, camera, image());
  }
};

void expect_near(const glm::vec3& actual, const glm::vec3& expected, float relative) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c] / expected[c], 1.0f, relative) << c;
}

TEST(PaperMeter, FindsEachChannelsExposureWhateverTheDesk) {
  for (const ToneCurve curve : scene::kToneCurves) {
    for (const glm::vec3& desk : {glm::vec3(0.4f, 0.05f, 0.04f), glm::vec3(0.02f)}) {
      Desk scene{.desk = desk, .curve = curve, .exposure = {1.6f, 1.1f, 0.7f}};
      const auto exposure = meter_paper(scene.samples(), curve);
      ASSERT_TRUE(exposure);
      expect_near(*exposure, scene.exposure, 0.02f);  // bytes
    }
  }
}

// A warm lamp and a camera that is balanced for it.
TEST(PaperMeter, BalancesAWarmLight) {
  const Desk scene{.light = {0.9f, 0.5f, 0.2f}, .exposure = {0.6f, 1.1f, 2.6f}};
  expect_near(meter_paper(scene.samples(), scene.curve).value(), scene.exposure, 0.02f);
}

TEST(PaperMeter, DoesNotFollowColoredPaperFar) {
  const Desk scene{.exposure = {0.05f, 1.0f, 1.0f}};
  EXPECT_NEAR(meter_paper(scene.samples(), scene.curve).value().x, 1.0f / kMostBalance, 0.01f);
}

// Overexposed paper says only how bright it is at least; the ink says more.
TEST(PaperMeter, MeasuresTheInkWhereThePaperIsClipped) {
  const Desk scene{.curve = ToneCurve::Linear, .exposure = glm::vec3(8.0f)};
  expect_near(meter_paper(scene.samples(), scene.curve).value(), scene.exposure, 0.03f);
}

// A camera with much contrast: the ink too dark to be measured, the paper clipped. Reinhard's curve
// would make such paper a hundred times as bright as it is, and burn out every virtual object.
TEST(PaperMeter, TakesNoReinhardCurveForOneThatClips) {
  const Desk scene{.curve = ToneCurve::Linear, .exposure = glm::vec3(2.6f), .ink = 0.001f};
  EXPECT_GT(evidence_for_linear(scene.samples()).value(), 0.5f);
  // Of clipped paper only the least brightness is known.
  expect_near(meter_paper(scene.samples(), ToneCurve::Linear).value(), scene.exposure, 0.05f);
}

// Darker paper tells less, but there the curves differ less too.
TEST(PaperMeter, TellsTheCamerasCurve) {
  for (const float exposure : {1.5f, 2.3f}) {
    for (const float ink : {0.04f, 0.055f}) {
      Desk scene{.exposure = glm::vec3(exposure), .ink = ink};
      EXPECT_LT(evidence_for_linear(scene.samples()).value(), 0.0f) << exposure << " " << ink;
      scene.curve = ToneCurve::Linear;
      EXPECT_GT(evidence_for_linear(scene.samples()).value(), 0.0f) << exposure << " " << ink;
    }
  }
}

TEST(PaperMeter, TakesNoOtherThingForPaper) {
  Desk grey;
  grey.paper = grey.ink = 0.3f;
  EXPECT_TRUE(grey.samples().empty()) << "no contrast";
  Desk small;
  small.pose.translation.z = 1.5;
  EXPECT_TRUE(small.samples().empty()) << "8 pixels wide";
  Desk cut_off;
  cut_off.pose.translation.x = 0.05;
  EXPECT_TRUE(cut_off.samples().empty()) << "beyond the image's border";
  Desk unlit;
  unlit.light = glm::vec3(0.0f);
  EXPECT_TRUE(unlit.samples().empty());
  EXPECT_FALSE(meter_paper({}, ToneCurve::Linear));
  EXPECT_FALSE(evidence_for_linear({}));
}

TEST(PaperMeter, NeedsARealSurfaceBelowTheMarker) {
  const Desk scene;
  MeterGrid grid = scene.grid();
  for (glm::vec4& entry : grid.white.pixels()) entry.w = 0.0f;
  EXPECT_TRUE(
      sample_paper(grid, {{&scene.pose, 1}, 0.05}, scene.camera, scene.camera, scene.image())
          .empty());
}

}  // namespace
}  // namespace amalgam::passes
