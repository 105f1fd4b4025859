#include "net/wire.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "codec/jpeg.h"
#include "common/build_info.h"
#include "net/client_error.h"
#include "protocol/limits.h"

namespace amalgam::net {
namespace {

// The decoder knows nothing of the protocol, but accepts what that lets through.
static_assert(codec::kMaxJpegSide == static_cast<int>(protocol::kMaxSide));
static_assert(codec::kMaxJpegPixels == static_cast<int>(protocol::kMaxPixels));

protocol::Hello good_hello() {
  protocol::Hello hello;
  protocol::Camera& camera = *hello.mutable_camera();
  camera.set_width(640);
  camera.set_height(480);
  camera.set_fx(600);
  camera.set_fy(601);
  camera.set_cx(319.5);
  camera.set_cy(239.5);
  return hello;
}

TEST(Wire, CameraOfAHello) {
  protocol::Hello hello = good_hello();
  for (const double k : {0.1, -0.2, 0.001, 0.002}) hello.mutable_camera()->add_distortion(k);
  hello.set_jpeg_quality(90);
  const frame::ViewOptions options = view_options_from(hello);
  EXPECT_EQ(options.camera.width, 640);
  EXPECT_EQ(options.camera.fy, 601);
  EXPECT_EQ(options.camera.distortion[1], -0.2);
  EXPECT_EQ(options.camera.distortion[4], 0.0);
  EXPECT_EQ(options.jpeg_quality, 90);
}

TEST(Wire, QualitiesUpToAHundredAreTaken) {
  protocol::Hello hello = good_hello();
  for (const std::uint32_t quality : {0u, 1u, 100u}) {
    hello.set_jpeg_quality(quality);
    EXPECT_EQ(view_options_from(hello).jpeg_quality, static_cast<int>(quality));
  }
  hello.set_jpeg_quality(101);
  EXPECT_THROW(view_options_from(hello), ClientError);
}

TEST(Wire, CamerasThatCannotBeRenderedWithAreRefused) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  using Change = std::function<void(protocol::Hello&)>;
  const std::vector<Change> changes{
      [](auto& hello) { hello.clear_camera(); },
      [](auto& hello) { hello.mutable_camera()->set_width(0); },
      [](auto& hello) { hello.mutable_camera()->set_height(2049); },
      [](auto& hello) { hello.mutable_camera()->set_width(0xffffffffu); },
      [](auto& hello) { hello.mutable_camera()->set_fx(0); },
      [](auto& hello) { hello.mutable_camera()->set_fy(kNaN); },
      [](auto& hello) { hello.mutable_camera()->set_cx(std::numeric_limits<double>::infinity()); },
      [](auto& hello) { hello.mutable_camera()->add_distortion(kNaN); },
      [](auto& hello) {
        for (int i = 0; i < 13; ++i) hello.mutable_camera()->add_distortion(0);
      },
      [](auto& hello) { hello.set_jpeg_quality(101); }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    protocol::Hello hello = good_hello();
    changes[i](hello);
    try {
      view_options_from(hello);
      ADD_FAILURE() << "change " << i;
    } catch (const ClientError& error) {
      EXPECT_EQ(error.code, protocol::Error::BAD_HELLO);
    }
  }
}

protocol::Environment fisheye_environment() {
  protocol::Environment environment;
  environment.set_image("jpeg");
  protocol::Fisheye& fisheye = *environment.mutable_fisheye();
  fisheye.set_width(1000);
  fisheye.set_height(900);
  fisheye.set_fx(300);
  fisheye.set_fy(301);
  fisheye.set_cx(500);
  fisheye.set_cy(450);
  fisheye.set_max_angle(1.6);
  fisheye.mutable_world_from_fisheye()->set_y(0.6);
  fisheye.mutable_world_from_fisheye()->set_z(0.8);
  return environment;
}

TEST(Wire, EnvironmentsAreEquirectangularUnlessALensIsGiven) {
  using Projection = frame::EnvironmentInput::Projection;
  protocol::Environment plain;
  plain.set_image("jpeg");
  EXPECT_EQ(environment_from(plain).projection, Projection::Equirectangular);
  EXPECT_EQ(environment_from(plain).image.size(), 4u);
  const frame::EnvironmentInput input = environment_from(fisheye_environment());
  EXPECT_EQ(input.projection, Projection::Fisheye);
  EXPECT_EQ(input.fisheye, (common::FisheyeModel{1000, 900, 300, 301, 500, 450, 1.6}));
  EXPECT_NEAR(input.world_from_fisheye.y, 0.6, 1e-15);
  EXPECT_NEAR(input.world_from_fisheye.z, 0.8, 1e-15);
}

TEST(Wire, EnvironmentsThatCannotBeUsedAreRefused) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  using Change = std::function<void(protocol::Environment&)>;
  const std::vector<Change> changes{
      [](auto& environment) { environment.clear_image(); },
      [](auto& environment) { environment.mutable_fisheye()->set_width(0); },
      [](auto& environment) { environment.mutable_fisheye()->set_height(2049); },
      [](auto& environment) { environment.mutable_fisheye()->set_width(0xffffffffu); },
      [](auto& environment) { environment.mutable_fisheye()->set_fx(kNaN); },
      [](auto& environment) { environment.mutable_fisheye()->set_max_angle(4); },
      [](auto& environment) { environment.mutable_fisheye()->clear_world_from_fisheye(); },
      [](auto& environment) {
        environment.mutable_fisheye()->mutable_world_from_fisheye()->set_x(kNaN);
      },
      [](auto& environment) {
        environment.mutable_fisheye()->mutable_world_from_fisheye()->set_x(1);
      }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    protocol::Environment environment = fisheye_environment();
    changes[i](environment);
    try {
      environment_from(environment);
      ADD_FAILURE() << "change " << i;
    } catch (const ClientError& error) {
      EXPECT_EQ(error.code, protocol::Error::BAD_ENVIRONMENT);
    }
  }
}

TEST(Wire, APoseWithoutRotationIsNotUsable) {
  protocol::CameraFrame frame;
  frame.add_poses()->set_marker(7);
  EXPECT_FALSE(common::is_usable(poses_from(frame).front()));
}

protocol::Composite composite_of(const frame::FrameOutput& output) {
  return composite_message({.frame = {}, .output = output}, 0).composite();
}

// Of what a governed frame was rendered with nothing is lost on the way, and others say nothing.
TEST(Wire, CompositeSaysWhatQualityWasChosen) {
  frame::FrameOutput output;
  EXPECT_FALSE(composite_of(output).has_quality());
  output.statistics.quality = {.level = 5,
                               .lowest_level = 40,
                               .samples_per_pixel = 4,
                               .adaptive = true,
                               .max_depth = 8,
                               .importance_cutoff = 0.1f,
                               .render_scale = 0.85f,
                               .jpeg_quality = 75,
                               .bound = frame::FrameQuality::Bound::Raster};
  const protocol::Quality quality = composite_of(output).quality();
  EXPECT_EQ(quality.level(), 5u);
  EXPECT_EQ(quality.lowest_level(), 40u);
  EXPECT_EQ(quality.samples_per_pixel(), 4u);
  EXPECT_TRUE(quality.adaptive());
  EXPECT_EQ(quality.max_depth(), 8u);
  EXPECT_EQ(quality.importance_cutoff(), 0.1f);
  EXPECT_EQ(quality.render_scale(), 0.85f);
  EXPECT_EQ(quality.jpeg_quality(), 75u);
  EXPECT_EQ(quality.bound(), protocol::Quality::RASTER);
}

// What a client must keep to, in the protocol's units.
TEST(Wire, TheWelcomeTellsLimitsAndMarkers) {
  SessionLimits limits;
  limits.ping_interval = std::chrono::milliseconds(1250);
  limits.idle_timeout = std::chrono::seconds(7);
  const auto envelope = welcome_message(9, limits, {"DICT_4X4_50", 0.04, 3, {3, 5}},
                                        fingerprint_message({.scene = "desk.gltf",
                                                             .scene_hash = "12ab",
                                                             .options = "--samples 4",
                                                             .hardware = "a GPU"}));
  const protocol::Welcome& welcome = envelope.welcome();
  EXPECT_EQ(welcome.session(), 9u);
  EXPECT_EQ(welcome.limits().ping_interval_ms(), 1250u);
  EXPECT_EQ(welcome.limits().idle_timeout_ms(), 7000u);
  EXPECT_EQ(welcome.limits().max_poses(), 64u);
  EXPECT_EQ(welcome.limits().max_message_bytes(), 4u * 1024 * 1024);
  EXPECT_EQ(welcome.fingerprint().scene(), "desk.gltf");
  EXPECT_EQ(welcome.fingerprint().scene_hash(), "12ab");
  EXPECT_EQ(welcome.fingerprint().options(), "--samples 4");
  EXPECT_EQ(welcome.fingerprint().hardware(), "a GPU");
  EXPECT_NE(welcome.fingerprint().build().find(common::build_id()), std::string::npos);
  EXPECT_EQ(welcome.markers().dictionary(), "DICT_4X4_50");
  EXPECT_EQ(welcome.markers().length(), 0.04);
  EXPECT_EQ(welcome.markers().world_marker(), 3);
  ASSERT_EQ(welcome.markers().ids_size(), 2);
  EXPECT_EQ(welcome.markers().ids(1), 5);
}

// Each number to its own field.
TEST(Wire, ACompositeTellsRaysAndPixels) {
  frame::FrameOutput output;
  output.statistics.rays = {1, 2, 3, 4, 5, 6};
  output.statistics.pixels = {.virtual_pixels = 7, .specular = 8, .refined = 9, .total = 10};
  output.statistics.nonfinite = 11;
  output.statistics.truncation_bound = {0.25, 0.5};
  const protocol::Composite composite = composite_of(output);
  EXPECT_EQ(composite.rays().primary(), 1u);
  EXPECT_EQ(composite.rays().reflection(), 2u);
  EXPECT_EQ(composite.rays().refraction(), 3u);
  EXPECT_EQ(composite.rays().shadow(), 4u);
  EXPECT_EQ(composite.rays().lookup(), 5u);
  EXPECT_EQ(composite.rays().reused(), 6u);
  EXPECT_EQ(composite.pixels().virtual_pixels(), 7u);
  EXPECT_EQ(composite.pixels().specular(), 8u);
  EXPECT_EQ(composite.pixels().total(), 10u);
  EXPECT_EQ(composite.nonfinite(), 11u);
  EXPECT_EQ(composite.truncation_bound().mean(), 0.25);
  EXPECT_EQ(composite.truncation_bound().worst(), 0.5);
}

}  // namespace
}  // namespace amalgam::net
