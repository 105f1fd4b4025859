// numerics B13: a scene and its camera moved away from the marker together look the same.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "parity/everything_case.h"
#include "parity/rendering.h"
#include "support/compare_images.h"

namespace amalgam::parity {
namespace {

// Everything this many metres further from the marker, on each of the marker's axes.
ParityCase moved(ParityCase original, double metres) {
  const glm::dvec3 by(metres, -metres, 0.5 * metres);
  const glm::dmat4 move = glm::translate(glm::dmat4(1.0), by);
  for (scene::Instance& instance : original.scene.instances) {
    instance.anchor_from_mesh = move * instance.anchor_from_mesh;
  }
  for (scene::PunctualLight& light : original.scene.punctual_lights) {
    light.anchor_from_light = move * light.anchor_from_light;
  }
  for (common::MarkerPose& pose : original.poses) {
    const glm::dmat4 camera_from_anchor =
        common::to_matrix(pose) * common::opencv_marker_from_gltf();
    pose.translation -= glm::dmat3(camera_from_anchor) * by;
  }
  return original;
}

test_support::ImageComparison compare_moved(frame::RendererMode mode, double metres) {
  frame::RendererSettings settings;
  settings.mode = mode;
  const ParityCase original = make_everything_case();
  const auto expected = render(original, settings),
             actual = render(moved(original, metres), settings);
  EXPECT_EQ(actual.statistics.nonfinite, 0u) << metres;
  return test_support::compare_images(test_support::as_floats(actual.composite),
                                      test_support::as_floats(expected.composite));
}

void expect_same(frame::RendererMode mode, std::initializer_list<double> distances) {
  for (const double metres : distances) {
    const auto comparison = compare_moved(mode, metres);
    EXPECT_LE(comparison.maximum, 1.0) << metres << "\n" << comparison.describe();
  }
}

TEST(FarWorld, LooksTheSameAThousandKilometresAway) {
  expect_same(frame::RendererMode::Hybrid, {1e6});
}

TEST(FarWorld, LooksTheSameTracedUpToFourThousandKilometres) {
  expect_same(frame::RendererMode::Raytrace, {1e3, 1e6, 4e6});
}

// The camera alone so far away, as by a wrong pose: the scene is smaller than a pixel.
TEST(FarWorld, ANearSceneIsNotSeenFromFarAway) {
  for (const auto mode : {frame::RendererMode::Hybrid, frame::RendererMode::Raytrace}) {
    frame::RendererSettings settings;
    settings.mode = mode;
    ParityCase far = make_everything_case();
    for (common::MarkerPose& pose : far.poses) pose.translation = {0.0, 0.0, 9e6};
    const auto rendering = render(far, settings);
    EXPECT_EQ(rendering.statistics.nonfinite, 0u);
    EXPECT_TRUE(
        test_support::images_are_same("camera image", rendering.composite, far.camera_image));
  }
}

// Beyond 10,000 km a pose is refused, and the camera's picture stays as it is.
TEST(FarWorld, BeyondThePosesLimitNothingIsDrawn) {
  const ParityCase original = make_everything_case();
  const auto rendering = render(moved(original, 2e7), {});
  EXPECT_TRUE(
      test_support::images_are_same("camera image", rendering.composite, original.camera_image));
}

}  // namespace
}  // namespace amalgam::parity
