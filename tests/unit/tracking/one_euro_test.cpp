// Smoothing against closed forms: how much noise is taken away, and how late motion comes.
#include "tracking/one_euro.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "tracking/pose_smoother.h"
#include "tracking/pose_solution.h"

namespace amalgam::tracking {
namespace {

constexpr double kStep = 1.0 / 30.0;  // seconds
constexpr double kTwoPi = 2.0 * std::numbers::pi;

PoseSmoother::Time at_frame(int frame) {
  return PoseSmoother::Time() + std::chrono::hours(1) +
         std::chrono::nanoseconds(static_cast<std::int64_t>(frame * kStep * 1e9));
}

TEST(OneEuro, AConstantStaysAsItIs) {
  OneEuroPosition position({.min_cutoff = 1.0, .beta = 2.0});
  OneEuroRotation rotation({.min_cutoff = 1.0, .beta = 2.0});
  const glm::dvec3 place(0.1, -0.2, 0.5);
  const glm::dquat turn = glm::angleAxis(2.0, glm::normalize(glm::dvec3(1, 2, 3)));
  for (int i = 0; i < 50; ++i) {
    EXPECT_LT(glm::distance(position.filter(place, kStep), place), 1e-15);
    // A quaternion and its negative are the same rotation.
    EXPECT_LT(angle_between(rotation.filter(i % 2 == 0 ? turn : -turn, kStep), turn), 1e-7);
  }
}

// An exponential low-pass of weight a turns white noise into noise whose second differences are
// smaller by a sqrt((2 + a) / (3 (2 - a))): its variance is a / (2 - a) of the noise's and its
// correlation (1 - a)^k; the second difference of that has 6 - 8 r + 2 r^2 = 2 (1 - r)(3 - r) of
// it, white noise 6.
TEST(OneEuro, JitterOfNoiseFallsAsItShould) {
  for (const double cutoff : {0.5, 1.0, 3.0}) {
    PoseSmoother smoother({.min_cutoff = cutoff});
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0, 0.001);
    const glm::dquat turn = glm::angleAxis(2.0, glm::normalize(glm::dvec3(1, 2, 3)));
    const auto random_vector = [&] {
      return glm::dvec3(noise(random), noise(random), noise(random));
    };
    for (int frame = 0; frame < 20000; ++frame) {
      common::MarkerPose pose;
      pose.translation = glm::dvec3(0, 0, 0.5) + random_vector();
      const glm::dvec3 half = 0.5 * random_vector();
      pose.rotation = glm::normalize(glm::dquat(1.0, half.x, half.y, half.z)) * turn;
      smoother.smooth({pose}, at_frame(frame));
    }
    const double a = smoothing_weight(cutoff, kStep);
    const double expected = a * std::sqrt((2 + a) / (3 * (2 - a)));
    const SmoothingReport report = smoother.report();
    const double position = report.position.smoothed_jitter / report.position.raw_jitter;
    const double rotation = report.rotation.smoothed_jitter / report.rotation.raw_jitter;
    std::printf(
        "cut-off %.1f Hz at 30 Hz: jitter times %.4f in position, %.4f in rotation, "
        "expected %.4f\n",
        cutoff, position, rotation, expected);
    // Two per cent: 20000 draws, whose mean squares are known to one.
    EXPECT_NEAR(position, expected, 0.02 * expected);
    EXPECT_NEAR(rotation, expected, 0.02 * expected);
    EXPECT_NEAR(report.position.raw_jitter, std::sqrt(3.0) * std::sqrt(6.0) * 0.001, 3e-5);
  }
}

// At a constant speed v the filter is late by 1 / (2 pi (min_cutoff + beta v)).
TEST(OneEuro, LagOfARampIsTheSteadyStates) {
  for (const OneEuroOptions options : {OneEuroOptions{1.0, 0.0}, {4.0, 0.0}, {1.0, 5.0}}) {
    constexpr double kSpeed = 0.3;  // m/s and rad/s
    OneEuroPosition position(options);
    OneEuroRotation rotation(options);
    double late = 0.0, turned_late = 0.0;
    for (int i = 0; i < 600; ++i) {
      const double t = i * kStep;
      const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, 3));
      const glm::dquat raw = glm::angleAxis(kSpeed * t, axis);
      late = (kSpeed * t - position.filter({kSpeed * t, 0, 0}, kStep).x) / kSpeed;
      turned_late = angle_between(raw, rotation.filter(raw, kStep)) / kSpeed;
    }
    const double expected = 1.0 / (kTwoPi * (options.min_cutoff + options.beta * kSpeed));
    EXPECT_NEAR(late, expected, 1e-6);
    EXPECT_NEAR(turned_late, expected, 1e-6);
  }
}

TEST(PoseSmoother, ReportsTheLagOfARamp) {
  PoseSmoother smoother({.min_cutoff = 2.0});
  for (int frame = 0; frame < 3000; ++frame) {
    common::MarkerPose pose;
    pose.translation = {0.01 * frame, 0, 0.5};
    pose.rotation = glm::angleAxis(0.02 * frame, glm::dvec3(0, 0, 1));
    smoother.smooth({pose}, at_frame(frame));
  }
  EXPECT_NEAR(smoother.report().position.lag, 1.0 / (kTwoPi * 2.0), 1e-6);
  EXPECT_NEAR(smoother.report().rotation.lag, 1.0 / (kTwoPi * 2.0), 1e-6);
  EXPECT_LT(smoother.report().position.raw_jitter, 1e-9);
}

// The point of it: as steady as a low cut-off at rest, as quick as a high one in motion.
TEST(PoseSmoother, BetaCutsTheLagOfFastMotionOnly) {
  const auto run = [](const OneEuroOptions& options) {
    PoseSmoother smoother(options);
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0, 0.0003);
    for (int frame = 0; frame < 3000; ++frame) {
      common::MarkerPose pose;
      const bool moves = frame % 300 >= 150;
      const double t = moves ? (frame % 300 - 150) * kStep : 0.0;
      pose.translation = {0.3 * std::sin(t * kTwoPi / 5.0) + noise(random), noise(random), 0.5};
      smoother.smooth({pose}, at_frame(frame));
    }
    return smoother.report().position;
  };
  const MotionFigures slow = run({1.0, 0.0}), quick = run({1.0, 20.0});
  std::printf("lag %.0f ms and jitter %.3f mm without beta, %.0f ms and %.3f mm with 20\n",
              1e3 * slow.lag, 1e3 * slow.smoothed_jitter, 1e3 * quick.lag,
              1e3 * quick.smoothed_jitter);
  EXPECT_NEAR(slow.lag, 1.0 / kTwoPi, 1e-3);
  EXPECT_LT(quick.lag, 0.3 * slow.lag);
  EXPECT_LT(quick.smoothed_jitter, 0.7 * quick.raw_jitter);
}

TEST(PoseSmoother, MarkersAreFilteredEachOnItsOwnAndForgotten) {
  PoseSmoother smoother({.min_cutoff = 0.1});
  const auto pose = [](int marker, double x) {
    common::MarkerPose made;
    made.marker = marker;
    made.translation = {x, 0, 0.5};
    return made;
  };
  smoother.smooth({pose(1, 0.0), pose(2, 1.0)}, at_frame(0));
  auto poses = smoother.smooth({pose(1, 0.1), pose(2, 1.0)}, at_frame(1));
  EXPECT_LT(poses[0].translation.x, 0.01);
  EXPECT_EQ(poses[1].translation.x, 1.0);
  EXPECT_EQ(poses[1].marker, 2);
  // Away for a few images: still the same marker.
  for (int frame = 2; frame < 10; ++frame) smoother.smooth({}, at_frame(frame));
  poses = smoother.smooth({pose(1, 0.1)}, at_frame(10));
  EXPECT_LT(poses[0].translation.x, 0.1);
  // Away for longer: where it is now is where it is.
  for (int frame = 11; frame < 20; ++frame) smoother.smooth({}, at_frame(frame));
  poses = smoother.smooth({pose(1, 0.1)}, at_frame(20));
  EXPECT_EQ(poses[0].translation.x, 0.1);
  // The same time again.
  poses = smoother.smooth({pose(1, 0.2)}, at_frame(20));
  EXPECT_EQ(poses[0].translation.x, 0.2);
}

}  // namespace
}  // namespace amalgam::tracking
