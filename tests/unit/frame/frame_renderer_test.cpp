#include "frame/frame_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "codec/jpeg.h"
#include "frame/default_view.h"
#include "support/compare_images.h"
#include "support/scene_builders.h"

namespace amalgam::frame {
namespace {

using test_support::add_object;

constexpr int kMarker = 40, kWidth = 96, kHeight = 72;

// A real table under the marker and, if wanted, things that stand on it.
scene::Scene table() {
  scene::Scene scene;
  scene.world.marker = kMarker;
  scene.environment = scene::Environment{common::ImageRgb32f(16, 8, glm::vec3(1.0f)), false};
  add_object(scene, test_support::make_floor(0.0f, 0.5f),
             test_support::make_diffuse(glm::vec3(0.6f)), scene::Role::Real);
  return scene;
}
void add_box(scene::Scene& scene, scene::Material material,
             scene::Role role = scene::Role::Virtual) {
  add_object(scene, test_support::make_box({-0.04f, 0.001f, -0.04f}, {0.04f, 0.08f, 0.04f}),
             std::move(material), role);
}

scene::Scene table_with_box_and_glass_ball() {
  scene::Scene scene = table();
  add_box(scene, test_support::make_diffuse(glm::vec3(0.7f, 0.3f, 0.2f), 0.4f));
  add_object(scene, test_support::make_sphere({0.09f, 0.03f, 0.02f}, 0.03f),
             test_support::make_glass(), scene::Role::Virtual);
  return scene;
}

common::ImageRgb8 stripes() {
  common::ImageRgb8 image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x)
      image.at(x, y) = common::Rgb8(120 + x, 200 - y, (x / 8 + y / 8) % 2 * 60 + 90);
  }
  return image;
}

FrameOutput render(scene::Scene scene, const FrameInput& input, ViewOptions options = {},
                   const RendererSettings& settings = {}) {
  if (options.camera.width == 0) options.camera = common::default_camera(kWidth, kHeight);
  FrameRenderer renderer(std::move(scene), settings);
  ViewState view(options);
  return renderer.render(view, input);
}

FrameInput jpeg_input(std::vector<common::MarkerPose> poses) {
  return {codec::encode_jpeg(stripes(), 90), std::move(poses)};
}

const PassRecord& pass(const FrameOutput& output, const std::string& name) {
  const auto& passes = output.statistics.passes;
  const auto found = std::find_if(passes.begin(), passes.end(),
                                  [&](const PassRecord& record) { return record.name == name; });
  if (found == passes.end()) throw std::runtime_error("no pass " + name);
  return *found;
}

// The invariant of the whole system: without anything virtual, or without a pose, the bytes that
// came are the bytes that go.
TEST(FrameRenderer, WithoutPosesTheBytesComeBack) {
  scene::Scene scene = table();
  add_box(scene, test_support::make_mirror());
  const FrameInput input = jpeg_input({});
  const FrameOutput output = render(scene, input);
  EXPECT_TRUE(output.unchanged);
  EXPECT_EQ(output.jpeg, std::get<Bytes>(input.image));
  for (const PassRecord& record : output.statistics.passes) {
    EXPECT_EQ(record.ran, record.name == "light extraction") << record.name;  // once, at first
  }
}

TEST(FrameRenderer, WithoutVirtualObjectsTheBytesComeBack) {
  scene::Scene scene = table();
  add_box(scene, test_support::make_mirror(), scene::Role::Real);
  add_box(scene, test_support::make_glass(), scene::Role::Real);
  for (const auto mode : {RendererMode::Hybrid, RendererMode::Raytrace}) {
    RendererSettings settings;
    settings.mode = mode;
    const FrameInput input = jpeg_input({default_pose(kMarker)});
    const FrameOutput output = render(scene, input, {}, settings);
    EXPECT_EQ(output.jpeg, std::get<Bytes>(input.image));
    for (const char* left_out : {"decode", "trace", "merge", "composite", "encode"})
      EXPECT_EQ(pass(output, left_out).reason, "no virtual object in the scene") << left_out;
  }
}

// A virtual object that is out of sight and whose shadow is too.
TEST(FrameRenderer, OutOfSightIsOutOfTheFrame) {
  scene::Scene scene = table();
  add_object(scene, test_support::make_box({-0.1f, 0.0f, 5.0f}, {0.1f, 0.1f, 5.2f}),
             test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Virtual);
  const FrameInput input = jpeg_input({default_pose(kMarker)});
  const FrameOutput output = render(scene, input);
  EXPECT_EQ(output.jpeg, std::get<Bytes>(input.image));
  EXPECT_FALSE(pass(output, "decode").ran);
  EXPECT_FALSE(pass(output, "composite").ran);
  EXPECT_EQ(pass(output, "encode").reason, "nothing virtual in view");
}

// Lower than the distance between two entries of the exposure meter.
TEST(FrameRenderer, APictureOfOneRowIsMetered) {
  scene::Scene scene = table();
  add_object(scene, test_support::make_box({-0.1f, 0.0f, -0.1f}, {0.1f, 0.1f, 0.1f}),
             test_support::make_diffuse(glm::vec3(0.5f)), scene::Role::Virtual);
  common::CameraModel camera = common::default_camera(6000, 1);
  camera.fx = camera.fy = 3000.0;
  FrameRenderer renderer(scene, {});
  ViewState view({.camera = camera, .keep_pixels = true});
  const common::ImageRgb8 grey(camera.width, camera.height, common::Rgb8(128));
  const FrameOutput output = renderer.render(view, {grey, {default_pose(kMarker)}});
  EXPECT_TRUE(pass(output, "meter").ran);
  EXPECT_EQ(output.pixels.size(), grey.size());
}

TEST(FrameRenderer, AnotherQualityIsEncodedEvenIfNothingChanged) {
  ViewOptions options;
  options.camera = common::default_camera(kWidth, kHeight);
  options.jpeg_quality = 40;
  const FrameInput input = jpeg_input({});
  const FrameOutput output = render(table(), input, options);
  EXPECT_FALSE(output.unchanged);
  EXPECT_LT(output.jpeg.size(), std::get<Bytes>(input.image).size());
}

TEST(FrameRenderer, DiffuseScenesTraceNothing) {
  scene::Scene scene = table();
  add_box(scene, test_support::make_diffuse(glm::vec3(0.2f, 0.5f, 0.3f)));
  const FrameOutput output = render(scene, jpeg_input({default_pose(kMarker)}));
  EXPECT_FALSE(output.unchanged);
  EXPECT_TRUE(pass(output, "diffuse").ran);
  EXPECT_EQ(pass(output, "trace").reason, "no specular object in the scene");
  EXPECT_EQ(pass(output, "warp").reason, "the lens does not distort");
  EXPECT_GT(output.statistics.pixels.virtual_pixels, 0u);
  EXPECT_EQ(output.statistics.pixels.specular, 0u);
  EXPECT_EQ(output.statistics.nonfinite, 0u);
}

// Pixels that nothing virtual touches keep their bytes; the object's do not.
TEST(FrameRenderer, TouchesOnlyWhatIsAffected) {
  scene::Scene scene = table();
  add_box(scene, test_support::make_mirror());
  ViewOptions options;
  options.camera = common::default_camera(kWidth, kHeight);
  options.keep_pixels = true;
  const FrameOutput output = render(scene, {stripes(), {default_pose(kMarker)}}, options);
  const common::ImageRgb8 camera = stripes();
  EXPECT_EQ(output.pixels.at(0, 0), camera.at(0, 0)) << "the corner sees past the table";
  int changed = 0;
  for (std::size_t i = 0; i < camera.pixels().size(); ++i) {
    if (output.pixels.pixels()[i] != camera.pixels()[i]) ++changed;
  }
  EXPECT_GT(changed, static_cast<int>(output.statistics.pixels.specular) / 2);
  EXPECT_TRUE(pass(output, "trace").ran);
  EXPECT_GT(output.statistics.rays.reflection, 0u);
}

// One picture, two ways to it; a fixed exposure, because the meters differ by a shadow's edge.
TEST(FrameRenderer, HybridAndRaytraceAgree) {
  const scene::Scene scene = table_with_box_and_glass_ball();
  ViewOptions options;
  options.camera = common::default_camera(kWidth, kHeight);
  options.keep_pixels = true;
  RendererSettings settings;
  settings.exposure = 0.8f;
  const FrameInput input{stripes(), {default_pose(kMarker)}};
  const FrameOutput hybrid = render(scene, input, options, settings);
  settings.mode = RendererMode::Raytrace;
  const FrameOutput traced = render(scene, input, options, settings);
  const test_support::Tolerance tolerance = {
      8.0, 0.05, "1/255: rounding; edges of shadows fall by a texel of the shadow map", 40};
  EXPECT_TRUE(test_support::images_agree("composite", test_support::as_floats(hybrid.pixels),
                                         test_support::as_floats(traced.pixels), tolerance));
}

TEST(FrameRenderer, ImageOfAnotherSizeIsTheClientsFault) {
  scene::Scene scene = table();
  add_box(scene, test_support::make_diffuse(glm::vec3(0.5f)));
  FrameInput input = jpeg_input({default_pose(kMarker)});
  ViewOptions options;
  options.camera = common::default_camera(64, 48);
  EXPECT_THROW(render(scene, input, options), codec::JpegError);
}

TEST(FrameRenderer, SecondFrameRedrawsNoShadowMap) {
  scene::Scene scene = table();
  add_box(scene, test_support::make_mirror());
  FrameRenderer renderer(scene, {});
  ViewState view({.camera = common::default_camera(kWidth, kHeight)});
  const FrameInput input = jpeg_input({default_pose(kMarker)});
  const FrameOutput first = renderer.render(view, input), second = renderer.render(view, input);
  EXPECT_TRUE(pass(first, "place instances").ran);
  EXPECT_EQ(pass(second, "place instances").reason, "nothing moved since the last frame");
  EXPECT_TRUE(pass(first, "shadow maps, virtual opaque").ran);
  EXPECT_EQ(pass(second, "shadow maps, virtual opaque").reason,
            "nothing moved since the last frame");
  EXPECT_EQ(first.jpeg, second.jpeg);
}

// What is freed between two frames, the second makes again: both are what they would be anyway.
TEST(FrameRenderer, FreedTargetsAreMadeAgain) {
  const auto two_frames = [](bool frees) {
    FrameRenderer renderer(table_with_box_and_glass_ball(), {});
    ViewState view({.camera = common::default_camera(kWidth, kHeight)});
    std::vector<Bytes> frames;
    for (int i = 0; i < 2; ++i) {
      common::MarkerPose pose = default_pose(kMarker);
      pose.translation.x += 0.01 * i;  // otherwise the first one's results are kept
      frames.push_back(renderer.render(view, jpeg_input({pose})).jpeg);
      if (frees) renderer.free_targets();
    }
    return frames;
  };
  const auto frames = two_frames(true);
  EXPECT_EQ(frames, two_frames(false));
  EXPECT_NE(frames[0], frames[1]);
}

// Adaptive sampling comes nearer to fixed nine samples than one sample does, with fewer rays than
// nine.
TEST(FrameRenderer, AdaptiveSamplesGoWhereTheyMatter) {
  const scene::Scene scene = table_with_box_and_glass_ball();
  ViewOptions options;
  options.camera = common::default_camera(kWidth, kHeight);
  options.keep_pixels = true;
  for (const auto mode : {RendererMode::Hybrid, RendererMode::Raytrace}) {
    const auto with_samples = [&](const char* samples) {
      RendererSettings settings;
      settings.mode = mode;
      settings.exposure = 0.8f;
      parse_samples(samples, settings);
      return render(scene, {stripes(), {default_pose(kMarker)}}, options, settings);
    };
    const FrameOutput one = with_samples("1"), nine = with_samples("9"),
                      adaptive = with_samples("adaptive");
    const auto distance = [&](const FrameOutput& output) {
      double sum = 0.0;
      for (std::size_t i = 0; i < nine.pixels.pixels().size(); ++i) {
        const glm::ivec3 d(
            glm::abs(glm::ivec3(output.pixels.pixels()[i]) - glm::ivec3(nine.pixels.pixels()[i])));
        sum += d.x + d.y + d.z;
      }
      return sum;
    };
    EXPECT_LT(distance(adaptive), 0.35 * distance(one));
    EXPECT_GT(adaptive.statistics.pixels.refined, 0u);
    EXPECT_LT(adaptive.statistics.pixels.refined, adaptive.statistics.pixels.total / 2);
    if (mode == RendererMode::Raytrace) {
      EXPECT_LT(adaptive.statistics.rays.primary, nine.statistics.rays.primary / 2);
    }
  }
}

TEST(FrameRenderer, LightsFollowTheEnvironmentAndOnlyIt) {
  scene::Scene scene = table();
  add_box(scene, test_support::make_diffuse(glm::vec3(0.5f)));
  RendererSettings settings;
  settings.exposure = 1.0f;
  FrameRenderer renderer(scene, settings);
  ViewState view({.camera = common::default_camera(kWidth, kHeight), .keep_pixels = true});
  const FrameInput input{stripes(), {default_pose(kMarker)}};
  const FrameOutput bright = renderer.render(view, input);
  EXPECT_TRUE(pass(bright, "light extraction").ran);
  EXPECT_EQ(pass(renderer.render(view, input), "light extraction").reason,
            "the environment has not changed");
  renderer.set_environment({common::ImageRgb32f(16, 8, glm::vec3(0.1f)), false});
  const FrameOutput dark = renderer.render(view, input);
  EXPECT_TRUE(pass(dark, "light extraction").ran);
  EXPECT_TRUE(pass(dark, "shadow maps, virtual opaque").ran) << "made for other lights";
  const auto middle = glm::ivec2(kWidth / 2, kHeight / 2);
  EXPECT_LT(dark.pixels.at(middle.x, middle.y).y, bright.pixels.at(middle.x, middle.y).y);
  EXPECT_EQ(pass(renderer.render(view, input), "light extraction").reason,
            "the environment has not changed");
}

// Said at the start and not at each frame.
TEST(FrameRenderer, MoreLightsThanRasterisingTakesAreRefusedAtOnce) {
  RendererSettings settings;
  settings.env_lights = scene::parse_env_light_options("median-cut:513");
  EXPECT_THROW(FrameRenderer(table(), settings), std::invalid_argument);
  settings.mode = RendererMode::Raytrace;
  EXPECT_NO_THROW(FrameRenderer(table(), settings));
  settings.mode = RendererMode::Hybrid;
  settings.env_lights = scene::parse_env_light_options("median-cut:512");
  scene::Scene scene = table();
  EXPECT_NO_THROW(FrameRenderer(scene, settings));
  scene.punctual_lights.emplace_back();
  EXPECT_THROW(FrameRenderer(scene, settings), std::invalid_argument);
}

TEST(FrameRenderer, BuffersAreThoseOfTheThesis) {
  scene::Scene scene = table();
  add_box(scene, test_support::make_mirror());
  FrameRenderer renderer(scene, {});
  ViewState view({.camera = common::default_camera(kWidth, kHeight)});
  FrameBuffers buffers;
  renderer.render(view, jpeg_input({default_pose(kMarker)}), &buffers);
  for (const char* name : {"mixed", "real", "environment_reflection", "virtual_mask",
                           "tracing_mask", "real_depth", "over", "difference"}) {
    EXPECT_TRUE(buffers.contains(name)) << name;
  }
}

}  // namespace
}  // namespace amalgam::frame
