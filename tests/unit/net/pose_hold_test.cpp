#include "net/pose_hold.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "net/server_config.h"

namespace amalgam::net {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::IsEmpty;

const PoseHold::Time kStart = PoseHold::Time() + std::chrono::hours(1);

common::MarkerPose good(int marker, double z = 0.5) {
  common::MarkerPose pose;
  pose.marker = marker;
  pose.translation.z = z;
  return pose;
}
common::MarkerPose bad(int marker) {
  return good(marker, std::numeric_limits<double>::quiet_NaN());
}

TEST(PoseHold, GoodPosesPass) {
  PoseHold memory(milliseconds(250));
  const auto resolved = memory.resolve({good(1), good(2)}, kStart);
  EXPECT_EQ(resolved.poses.size(), 2u);
  EXPECT_THAT(resolved.rejected, IsEmpty());
}

TEST(PoseHold, ABadPoseIsReplacedByTheLastGoodOneWhileThatIsFresh) {
  PoseHold memory(milliseconds(250));
  memory.resolve({good(1, 0.7)}, kStart);
  const auto held = memory.resolve({bad(1), good(2)}, kStart + milliseconds(250));
  ASSERT_EQ(held.poses.size(), 2u);
  EXPECT_EQ(held.poses[1].marker, 1);
  EXPECT_EQ(held.poses[1].translation.z, 0.7);
  EXPECT_THAT(held.rejected, ElementsAre(1));
  // Holding does not make it fresh again.
  const auto late = memory.resolve({bad(1)}, kStart + milliseconds(251));
  ASSERT_EQ(late.poses.size(), 1u);
  EXPECT_EQ(late.poses[0].marker, 2);
  EXPECT_THAT(late.rejected, ElementsAre(1));
}

TEST(PoseHold, ALostMarkerIsHeldJustAsLong) {
  PoseHold memory(milliseconds(250));
  memory.resolve({good(1, 0.7), good(2, 0.8)}, kStart);
  const auto held = memory.resolve({good(2, 0.9)}, kStart + milliseconds(100));
  ASSERT_EQ(held.poses.size(), 2u);
  EXPECT_EQ(held.poses[0].translation.z, 0.9);
  EXPECT_EQ(held.poses[1].marker, 1);
  EXPECT_EQ(held.poses[1].translation.z, 0.7);
  EXPECT_THAT(held.rejected, IsEmpty());
  // Each for its own time, and being held does not count as being seen.
  EXPECT_EQ(memory.resolve({}, kStart + milliseconds(250)).poses.size(), 2u);
  const auto later = memory.resolve({}, kStart + milliseconds(251));
  ASSERT_EQ(later.poses.size(), 1u);
  EXPECT_EQ(later.poses[0].marker, 2);
  EXPECT_THAT(memory.resolve({}, kStart + milliseconds(351)).poses, IsEmpty());
}

TEST(PoseHold, NothingIsMadeUpForAMarkerThatWasNeverThere) {
  PoseHold memory(milliseconds(250));
  EXPECT_THAT(memory.resolve({bad(3)}, kStart).poses, IsEmpty());
  EXPECT_THAT(memory.resolve({}, kStart).poses, IsEmpty());
}

TEST(PoseHold, OfSeveralPosesOfOneMarkerTheFirstUsableCounts) {
  PoseHold memory(milliseconds(250));
  const auto resolved = memory.resolve({bad(1), good(1, 0.6), good(1, 0.9)}, kStart);
  ASSERT_EQ(resolved.poses.size(), 1u);
  EXPECT_EQ(resolved.poses[0].translation.z, 0.6);
  EXPECT_THAT(resolved.rejected, ElementsAre(1));
}

TEST(PoseHold, NeverHoldsMoreThanFitIntoAFrame) {
  PoseHold memory(milliseconds(250));
  std::size_t most = 0;
  for (int frame = 0; frame < 100; ++frame) {
    std::vector<common::MarkerPose> poses;
    for (int i = 0; i < 40; ++i) poses.push_back(good(40 * frame + i));
    const auto resolved = memory.resolve(poses, kStart + milliseconds(frame));
    // The frame's own always pass; of earlier ones the newest are kept.
    EXPECT_EQ(resolved.poses.front().marker, 40 * frame);
    most = std::max(most, resolved.poses.size());
  }
  EXPECT_EQ(most, 64u);
}

// The protocol promises clients 250 ms.
TEST(PoseHold, SessionsHoldAsLongAsTheProtocolSays) {
  EXPECT_EQ(SessionLimits().pose_hold, milliseconds(250));
}

}  // namespace
}  // namespace amalgam::net
