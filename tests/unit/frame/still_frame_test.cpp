// What is reused while nothing moves gives the picture that making everything anew gives, and only
// as long as nothing moves.
#include "frame/still_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "frame/default_view.h"
#include "frame/frame_renderer.h"
#include "scene/gltf/loader.h"
#include "support/compare_images.h"

namespace amalgam::frame {
namespace {

constexpr int kWidth = 160, kHeight = 120;

scene::Scene load(const std::string& name) {
  return scene::load_scene(AMALGAM_SOURCE_DIR "/deploy/scenes/" + name + ".gltf");
}

// Another picture for each number: brighter, with stripes elsewhere.
common::ImageRgb8 camera_image(int number) {
  common::ImageRgb8 image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      image.at(x, y) =
          common::Rgb8(60 + 20 * number + (x + 5 * number) / 8 % 2 * 50, 100 + y / 2, 90 + x / 4);
    }
  }
  return image;
}

// The same frames one after the other, with and without reuse.
class Pair {
 public:
  Pair(const std::string& scene, RendererSettings settings)
      : reusing_(load(scene), settings),
        view_(options()),
        anew_(load(scene), without(settings)),
        anew_view_(options()) {}

  // Compares, and returns what the one that may reuse gave.
  FrameOutput render(int number, const std::vector<common::MarkerPose>& poses) {
    const FrameInput input{camera_image(number), poses};
    FrameOutput output = reusing_.render(view_, input);
    const FrameOutput expected = anew_.render(anew_view_, input);
    EXPECT_TRUE(test_support::images_are_same("frame-" + std::to_string(number), output.pixels,
                                              expected.pixels));
    EXPECT_EQ(output.unchanged, expected.unchanged) << "frame " << number;
    EXPECT_EQ(output.statistics.exposure, expected.statistics.exposure);
    EXPECT_EQ(output.statistics.nonfinite, expected.statistics.nonfinite);
    EXPECT_EQ(output.statistics.pixels.virtual_pixels, expected.statistics.pixels.virtual_pixels);
    EXPECT_EQ(output.statistics.pixels.specular, expected.statistics.pixels.specular);
    EXPECT_EQ(output.statistics.rays.cast() + output.statistics.rays.reused,
              expected.statistics.rays.cast());
    return output;
  }

  common::MarkerPose pose() const { return default_pose(reusing_.scene().world.marker); }
  void set_environment(float radiance) {
    for (FrameRenderer* renderer : {&reusing_, &anew_}) {
      renderer->set_environment({common::ImageRgb32f(16, 8, glm::vec3(radiance)), false});
    }
  }

 private:
  static ViewOptions options() {
    return {.camera = common::default_camera(kWidth, kHeight), .keep_pixels = true};
  }
  static RendererSettings without(RendererSettings settings) {
    settings.reuse_still_frames = false;
    return settings;
  }

  FrameRenderer reusing_;
  ViewState view_;
  FrameRenderer anew_;
  ViewState anew_view_;
};

// Whether each pass ran.
std::map<std::string, bool> ran(const FrameOutput& output) {
  std::map<std::string, bool> passes;
  for (const PassRecord& pass : output.statistics.passes) passes[pass.name] = pass.ran;
  return passes;
}

bool reused(const FrameOutput& output) {
  const auto& passes = output.statistics.passes;
  return std::any_of(passes.begin(), passes.end(), [](const PassRecord& pass) {
    return pass.name == "trace" && pass.reason == "nothing moved since the last frame";
  });
}

struct StillCase {
  const char* scene;
  RendererMode mode;
  int samples = 1;
};

class StillFrames : public testing::TestWithParam<StillCase> {};

TEST_P(StillFrames, AreTheSamePictureAsMadeAnew) {
  RendererSettings settings;
  settings.mode = GetParam().mode;
  settings.samples_per_pixel = GetParam().samples;
  Pair pair(GetParam().scene, settings);
  for (int number = 0; number < 5; ++number) {
    const FrameOutput output = pair.render(number, {pair.pose()});
    EXPECT_EQ(reused(output), number >= 2) << number;
    EXPECT_FALSE(output.unchanged);
    if (number < 2) continue;
    EXPECT_EQ(output.statistics.rays.cast(), 0u);
    for (const auto& [pass, did_run] : ran(output)) {
      const bool looks_up_colors = pass == "decode" || pass == "exposure" || pass == "resolve" ||
                                   pass == "look up" || pass == "merge" || pass == "composite";
      EXPECT_TRUE(!did_run || looks_up_colors) << pass;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, StillFrames,
                         testing::Values(StillCase{"complex", RendererMode::Hybrid},
                                         StillCase{"complex", RendererMode::Hybrid, 4},
                                         StillCase{"complex", RendererMode::Raytrace},
                                         StillCase{"mirror", RendererMode::Hybrid},
                                         StillCase{"glassware", RendererMode::Hybrid},
                                         StillCase{"glassware", RendererMode::Diffuse},
                                         StillCase{"diffuse", RendererMode::Hybrid}),
                         [](const auto& parameter) {
                           const char* mode =
                               parameter.param.mode == RendererMode::Hybrid     ? "Hybrid"
                               : parameter.param.mode == RendererMode::Raytrace ? "Raytrace"
                                                                                : "Diffuse";
                           return std::string(parameter.param.scene) + mode +
                                  std::to_string(parameter.param.samples);
                         });

TEST(StillFrame, AMovedMarkerMakesAllAnew) {
  Pair pair("complex", {});
  common::MarkerPose pose = pair.pose();
  for (int number = 0; number < 3; ++number) pair.render(number, {pose});
  pose.translation.x += 1e-9;
  EXPECT_FALSE(reused(pair.render(3, {pose})));
  EXPECT_FALSE(reused(pair.render(4, {pose})));
  EXPECT_TRUE(reused(pair.render(5, {pose})));
  EXPECT_FALSE(reused(pair.render(6, {})));  // the marker is lost
  EXPECT_FALSE(reused(pair.render(7, {pose})));
}

TEST(StillFrame, AMarkerThatNothingStandsOnMayMove) {
  Pair pair("complex", {});
  common::MarkerPose other = pair.pose();
  other.marker = 77;
  for (int number = 0; number < 4; ++number) {
    other.translation.x += 0.01;
    EXPECT_EQ(reused(pair.render(number, {pair.pose(), other})), number >= 2);
  }
}

TEST(StillFrame, AnotherEnvironmentMakesAllAnew) {
  Pair pair("mirror", {});
  for (int number = 0; number < 3; ++number) pair.render(number, {pair.pose()});
  pair.set_environment(0.5f);
  EXPECT_FALSE(reused(pair.render(3, {pair.pose()})));
  // The same lights again: a map that differs only in what mirrors show is noticed too.
  pair.render(4, {pair.pose()});
  EXPECT_TRUE(reused(pair.render(5, {pair.pose()})));
  pair.set_environment(0.5f);
  EXPECT_FALSE(reused(pair.render(6, {pair.pose()})));
}

// Refinement looks for edges in the camera's colors.
TEST(StillFrame, RefinedFramesAreMadeAnew) {
  RendererSettings settings;
  settings.adaptive_threshold = kDefaultAdaptiveThreshold;
  Pair pair("mirror", settings);
  for (int number = 0; number < 4; ++number)
    EXPECT_FALSE(reused(pair.render(number, {pair.pose()})));
}

TEST(StillFrame, WhoWantsProvenanceGetsIt) {
  FrameRenderer renderer(load("mirror"), {});
  ViewState view({.camera = common::default_camera(kWidth, kHeight), .keep_pixels = true});
  const common::MarkerPose pose = default_pose(renderer.scene().world.marker);
  for (int number = 0; number < 3; ++number) renderer.render(view, {camera_image(number), {pose}});
  view.options.keep_provenance = true;
  EXPECT_TRUE(renderer.render(view, {camera_image(3), {pose}}).provenance.has_value());
}

StillKey key_at(double x) {
  StillKey key;
  key.scene.camera_from_world[3][0] = x;
  return key;
}

TEST(StillView, KeepsFromTheSecondEqualFrameOn) {
  StillView view;
  view.begin(key_at(1));
  EXPECT_FALSE(view.wants_frame());
  view.begin(key_at(1));
  EXPECT_TRUE(view.wants_frame());
  view.keep({});
  EXPECT_NE(view.frame(), nullptr);
  EXPECT_FALSE(view.wants_frame());
  view.begin(key_at(2));
  EXPECT_EQ(view.frame(), nullptr);
}

TEST(StillView, TriesATooLargeFrameOnce) {
  StillView view;
  view.begin(key_at(1));
  view.begin(key_at(1));
  view.give_up();
  view.begin(key_at(1));
  EXPECT_FALSE(view.wants_frame());
  view.begin(key_at(2));
  view.begin(key_at(2));
  EXPECT_TRUE(view.wants_frame());
}

}  // namespace
}  // namespace amalgam::frame
