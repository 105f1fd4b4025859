#include "net/pose_memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace amalgam::net {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::IsEmpty;

const PoseMemory::Time kStart = PoseMemory::Time() + std::chrono::hours(1);

core::MarkerPose good(int marker, double z = 0.5) {
  core::MarkerPose pose;
  pose.marker = marker;
  pose.translation.z = z;
  return pose;
}
core::MarkerPose bad(int marker) {
  return good(marker, std::numeric_limits<double>::quiet_NaN());
}

TEST(PoseMemory, GoodPosesPass) {
  PoseMemory memory(milliseconds(250));
  const auto resolved = memory.resolve({good(1), good(2)}, kStart);
  EXPECT_EQ(resolved.poses.size(), 2u);
  EXPECT_THAT(resolved.rejected, IsEmpty());
}

TEST(PoseMemory, ABadPoseIsReplacedByTheLastGoodOneWhileThatIsFresh) {
  PoseMemory memory(milliseconds(250));
  memory.resolve({good(1, 0.7)}, kStart);
  const auto held = memory.resolve({bad(1), good(2)}, kStart + milliseconds(250));
  ASSERT_EQ(held.poses.size(), 2u);
  EXPECT_EQ(held.poses[0].marker, 1);
  EXPECT_EQ(held.poses[0].translation.z, 0.7);
  EXPECT_THAT(held.rejected, ElementsAre(1));
  // Holding does not make it fresh again.
  const auto late = memory.resolve({bad(1)}, kStart + milliseconds(251));
  EXPECT_THAT(late.poses, IsEmpty());
  EXPECT_THAT(late.rejected, ElementsAre(1));
}

TEST(PoseMemory, NothingIsMadeUpForAMarkerThatIsNotThere) {
  PoseMemory memory(milliseconds(250));
  memory.resolve({good(1)}, kStart);
  EXPECT_THAT(memory.resolve({}, kStart + milliseconds(10)).poses, IsEmpty());
  EXPECT_THAT(memory.resolve({bad(3)}, kStart + milliseconds(20)).poses, IsEmpty());
}

}  // namespace
}  // namespace amalgam::net
