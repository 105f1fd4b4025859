#include "client/synthetic/synthetic_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "client/synthetic/synthetic_path.h"
#include "client/tracking/calibration.h"
#include "client/tracking/marker_tracker.h"

namespace amalgam::client {
namespace {

std::shared_ptr<const SyntheticDesk> desk() {
  static const auto shared = std::make_shared<const SyntheticDesk>(PrintedMarker{});
  return shared;
}

common::CameraModel distorting_camera() {
  common::CameraModel camera = common::default_camera(800, 600);
  camera.distortion = {0.0995485, -0.206384, 0.00754589, 0.00336531};
  return camera;
}

struct PoseErrors {
  double max_degrees = 0.0, rms_degrees = 0.0;
  double max_mm = 0.0, rms_mm = 0.0;
  int seen = 0, frames = 0;
};

PoseErrors measure(const common::CameraModel& camera, const common::CameraModel& assumed) {
  const SyntheticCamera synthetic(camera, desk());
  MarkerTracker tracker({}, assumed);
  PoseErrors errors;
  for (std::uint64_t frame = 0; frame < kSyntheticPeriod; frame += 12) {
    const SyntheticFrame made = synthetic.render(frame);
    ++errors.frames;
    const auto poses = tracker.track(made.image);
    if (poses.size() != 1 || poses[0].marker != 40) continue;
    ++errors.seen;
    const double degrees =
        glm::degrees(tracking::angle_between(poses[0].rotation, made.pose.rotation));
    const double mm = 1000 * glm::distance(poses[0].translation, made.pose.translation);
    errors.max_degrees = std::max(errors.max_degrees, degrees);
    errors.max_mm = std::max(errors.max_mm, mm);
    errors.rms_degrees += degrees * degrees;
    errors.rms_mm += mm * mm;
  }
  errors.rms_degrees = std::sqrt(errors.rms_degrees / errors.seen);
  errors.rms_mm = std::sqrt(errors.rms_mm / errors.seen);
  std::printf("%d of %d: rotation rms %.3f max %.3f degrees, position rms %.2f max %.2f mm\n",
              errors.seen, errors.frames, errors.rms_degrees, errors.max_degrees, errors.rms_mm,
              errors.max_mm);
  return errors;
}

// Corners are found to 0.05 pixel (root mean square) of a marker 50 to 80 pixels wide: a thousandth
// of half a metre is 0.5 mm along the line of sight, and a tilt shows by a tenth of a degree, more
// where the marker faces the camera. Root mean squares well below that, maxima a few times it.
constexpr double kMaxMm = 1.5, kRmsMm = 0.4, kMaxDegrees = 0.8, kRmsDegrees = 0.2;

void expect_good(const PoseErrors& errors) {
  EXPECT_EQ(errors.seen, errors.frames);
  EXPECT_LT(errors.max_mm, kMaxMm);
  EXPECT_LT(errors.rms_mm, kRmsMm);
  EXPECT_LT(errors.max_degrees, kMaxDegrees);
  EXPECT_LT(errors.rms_degrees, kRmsDegrees);
}

TEST(SyntheticCamera, DetectedPosesAreTheTrueOnes) {
  const common::CameraModel camera = common::default_camera(800, 600);
  expect_good(measure(camera, camera));
}

TEST(SyntheticCamera, DetectedPosesAreTheTrueOnesThroughADistortingLens) {
  const common::CameraModel camera = distorting_camera();
  expect_good(measure(camera, camera));
}

TEST(SyntheticCamera, DistortionIsReallyThere) {
  // Whoever ignores the lens gets worse poses: otherwise the test above would prove nothing.
  common::CameraModel ideal = distorting_camera();
  ideal.distortion = {};
  EXPECT_GT(measure(distorting_camera(), ideal).rms_mm, 1.5 * kRmsMm);
}

TEST(SyntheticCamera, MarkerEdgesLieWhereThePoseSays) {
  const common::CameraModel camera = common::default_camera(400, 300);
  const auto pose = look_at({0.0, -0.1, 0.3}, {0.0, 0.0, 0.0}, 40);
  const auto image = SyntheticCamera(camera, desk()).render(pose);
  const auto grey_at = [&](double x, double y) {
    const glm::dvec3 point(common::to_matrix(pose) * glm::dvec4(x, y, 0, 1));
    const glm::dvec2 pixel = common::project(camera, point).value();
    return int{
        image.at(static_cast<int>(std::lround(pixel.x)), static_cast<int>(std::lround(pixel.y))).g};
  };
  for (const double side : {-1.0, 1.0}) {
    EXPECT_LT(grey_at(side * 0.0225, 0), 60) << "the black border";
    EXPECT_LT(grey_at(0, side * 0.0225), 60);
    EXPECT_GT(grey_at(side * 0.0275, 0), 200) << "the white margin";
    EXPECT_GT(grey_at(0, side * 0.0275), 200);
  }
}

TEST(SyntheticCamera, FramesAreAFunctionOfTheirNumber) {
  const SyntheticCamera camera(common::default_camera(160, 120), desk());
  EXPECT_EQ(camera.render(3).image, camera.render(3 + kSyntheticPeriod).image);
  EXPECT_NE(camera.render(3).image, camera.render(4).image);
}

TEST(SyntheticPath, StaysInFrontAndInReachAndKeepsMoving) {
  const auto camera = common::default_camera(800, 600);
  common::MarkerPose last = synthetic_pose(kSyntheticPeriod - 1, 40);
  for (std::uint64_t frame = 0; frame < kSyntheticPeriod; ++frame) {
    const auto pose = synthetic_pose(frame, 40);
    ASSERT_TRUE(common::is_usable(pose));
    const glm::dvec3 eye(common::rigid_inverse(common::to_matrix(pose))[3]);
    const double distance = glm::distance(eye, glm::dvec3(0.0, 0.05, 0.03));
    EXPECT_GE(distance, 0.35 - 1e-9);
    EXPECT_LE(distance, 0.60 + 1e-9);
    EXPECT_GT(eye.z, 0.1);
    const auto pixel = common::project(camera, pose.translation);
    ASSERT_TRUE(pixel);
    EXPECT_TRUE(pixel->x > 100 && pixel->x < 700 && pixel->y > 100 && pixel->y < 560);
    const double step = glm::distance(pose.translation, last.translation);
    EXPECT_GT(step + tracking::angle_between(pose.rotation, last.rotation), 1e-4);
    EXPECT_LT(step, 0.02);
    last = pose;
  }
}

TEST(SyntheticDesk, RefusesMarkersThatDoNotExistOrFit) {
  EXPECT_THROW(SyntheticDesk({.dictionary = "DICT_NONE"}), std::runtime_error);
  EXPECT_THROW(SyntheticDesk({.id = 250}), std::runtime_error);
  EXPECT_THROW(SyntheticDesk({.length = 0.3}), std::runtime_error);
}

TEST(MarkerTracker, RefusesImagesOfAnotherSize) {
  MarkerTracker tracker({}, common::default_camera(640, 480));
  EXPECT_THROW(tracker.track(common::ImageRgb8(320, 240)), std::invalid_argument);
  EXPECT_TRUE(tracker.track(common::ImageRgb8(640, 480)).empty());
}

TEST(MarkerTracker, LooksForTheMarkersItIsAskedFor) {
  const common::CameraModel camera = common::default_camera(800, 600);
  const auto image = SyntheticCamera(camera, desk()).render(0).image;
  EXPECT_EQ(MarkerTracker({.ids = {7, 40}}, camera).track(image).size(), 1u);
  EXPECT_TRUE(MarkerTracker({.ids = {7}}, camera).track(image).empty());
  EXPECT_THROW(MarkerTracker({.dictionary = "DICT_6X6"}, camera), std::runtime_error);
  EXPECT_THROW(MarkerTracker({.marker_length = 0.0}, camera), std::runtime_error);
}

}  // namespace
}  // namespace amalgam::client
