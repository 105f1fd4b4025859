#include "net/wire.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "net/client_error.h"

namespace amalgam::net {
namespace {

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

TEST(Wire, PosesKeepTheirOrderOfComponents) {
  protocol::CameraFrame frame;
  core::MarkerPose pose;
  pose.marker = 7;
  pose.rotation = glm::dquat(0.5, 0.1, 0.2, 0.3);  // w first
  pose.translation = {1, 2, 3};
  *frame.add_poses() = pose_to_wire(pose);
  EXPECT_EQ(frame.poses(0).rotation().w(), 0.5);
  EXPECT_EQ(frame.poses(0).rotation().x(), 0.1);
  const auto back = poses_from(frame);
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(back[0].rotation, pose.rotation);
  EXPECT_EQ(back[0].translation, pose.translation);
}

TEST(Wire, APoseWithoutRotationIsNotUsable) {
  protocol::CameraFrame frame;
  frame.add_poses()->set_marker(7);
  EXPECT_FALSE(core::is_usable(poses_from(frame).front()));
}

}  // namespace
}  // namespace amalgam::net
