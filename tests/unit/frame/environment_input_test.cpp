#include "frame/environment_input.h"

#include <gtest/gtest.h>

#include <numbers>

#include "codec/jpeg.h"

namespace amalgam::frame {
namespace {

// A fish-eye that looks along +z and sees the half sphere before it; red left of its axis, green
// right of it.
common::FisheyeModel half_sphere(int side) {
  const double half = std::numbers::pi / 2;
  return {side, side, side / 2.0 / half, side / 2.0 / half, (side - 1) / 2.0, (side - 1) / 2.0,
          half};
}
common::ImageRgb8 two_halves(int side) {
  common::ImageRgb8 picture(side, side, common::Rgb8(255, 0, 0));
  for (int y = 0; y < side; ++y) {
    for (int x = side / 2; x < side; ++x) picture.at(x, y) = common::Rgb8(0, 255, 0);
  }
  return picture;
}

TEST(UnrollFisheye, PutsWhatIsSeenWhereItIs) {
  // The lens's axes are x right, y down, z forward; without rotation its y points along the world's
  // +y, so what is on its right is at the world's +x.
  const scene::Environment map = unroll_fisheye(two_halves(200), half_sphere(200), {1, 0, 0, 0});
  EXPECT_TRUE(map.low_dynamic_range);
  const glm::vec3 right = scene::sample_environment(map, glm::normalize(glm::vec3(0.5f, 0, 1)));
  const glm::vec3 left = scene::sample_environment(map, glm::normalize(glm::vec3(-0.5f, 0, 1)));
  EXPECT_NEAR(right.y, 1.0f, 1e-3f);
  EXPECT_NEAR(left.x, 1.0f, 1e-3f);
  // Behind the lens: the mean of both.
  const glm::vec3 behind = scene::sample_environment(map, {0, 0, -1});
  EXPECT_NEAR(behind.x, 0.5f, 0.02f);
  EXPECT_NEAR(behind.y, 0.5f, 0.02f);
}

TEST(UnrollFisheye, TurnsWithTheLens) {
  // Turned by 90 degrees about y, the lens looks along the world's +x.
  const glm::dquat world_from_fisheye(std::sqrt(0.5), 0, std::sqrt(0.5), 0);
  const scene::Environment map =
      unroll_fisheye(two_halves(200), half_sphere(200), world_from_fisheye);
  EXPECT_NEAR(scene::sample_environment(map, glm::normalize(glm::vec3(1, 0, -0.5f))).y, 1.0f,
              1e-3f);
  EXPECT_NEAR(scene::sample_environment(map, glm::normalize(glm::vec3(1, 0, 0.5f))).x, 1.0f, 1e-3f);
}

TEST(MakeEnvironment, SizesMustAgree) {
  EnvironmentInput input;
  input.image = codec::encode_jpeg(two_halves(100), 90);
  input.projection = EnvironmentInput::Projection::Fisheye;
  input.fisheye = half_sphere(120);
  EXPECT_THROW(make_environment(input), std::invalid_argument);
  input.fisheye = half_sphere(100);
  EXPECT_NO_THROW(make_environment(input));
}

}  // namespace
}  // namespace amalgam::frame
