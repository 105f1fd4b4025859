// The same scene at 1 mm, 1 m and 1 km gives the same picture.
#include <gtest/gtest.h>

#include <set>

#include "parity/rendering.h"
#include "stiff/stiff_case.h"
#include "support/compare_images.h"

namespace amalgam::stiff {
namespace {

using test_support::StiffScene;

constexpr int kWidth = 64, kHeight = 48;
constexpr std::size_t kMostOnEdges = kWidth * kHeight / 500;

// Vertices of different sizes round differently: a sample on an edge may fall on its other side.
const test_support::Tolerance kSame = {1.0, 0.02, "1/255: rounding to bytes", kMostOnEdges};

parity::Rendering picture(const StiffScene& scene, frame::RendererMode mode) {
  frame::RendererSettings settings;
  settings.mode = mode;
  settings.trace_shadow_edges = mode == frame::RendererMode::Hybrid;
  return parity::render(make_case(scene, kWidth, kHeight), settings);
}

void expect_same_pictures(const std::string& stem, frame::RendererMode mode) {
  const parity::Rendering expected = picture(test_support::stiff_scene(stem + "-1m"), mode);
  EXPECT_EQ(expected.statistics.nonfinite, 0u) << stem;
  EXPECT_GT(expected.statistics.pixels.virtual_pixels, kWidth * kHeight / 10u) << stem;
  for (const char* size : {"-1mm", "-1km"}) {
    const parity::Rendering actual = picture(test_support::stiff_scene(stem + size), mode);
    EXPECT_EQ(actual.statistics.nonfinite, 0u) << stem << size;
    EXPECT_TRUE(test_support::images_agree(stem + size + "-" + parity::mode_name(mode),
                                           test_support::as_floats(actual.composite),
                                           test_support::as_floats(expected.composite), kSame));
  }
}

TEST(StiffSizes, LookAlikeTraced) {
  std::set<std::string> stems;
  for (const StiffScene& scene : test_support::stiff_scenes()) {
    stems.insert(scene.name.substr(0, scene.name.rfind('-')));
  }
  for (const std::string& stem : stems) expect_same_pictures(stem, frame::RendererMode::Raytrace);
}

// One of each kind: a rasteriser takes long to set up.
class StiffSizesHybrid : public testing::TestWithParam<std::string> {};

TEST_P(StiffSizesHybrid, LookAlike) {
  expect_same_pictures(GetParam(), frame::RendererMode::Hybrid);
}

INSTANTIATE_TEST_SUITE_P(Scenes, StiffSizesHybrid,
                         testing::Values("corridor-0.9", "stack-8", "ball-2.42", "nested", "lens"),
                         [](const testing::TestParamInfo<std::string>& info) {
                           return info.param.substr(0, info.param.find('-'));
                         });

}  // namespace
}  // namespace amalgam::stiff
