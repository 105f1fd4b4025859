#include "trace/media.h"

#include <gtest/gtest.h>

namespace amalgam::trace {
namespace {

TEST(Media, InnermostIsTheLastEntered) {
  const Media air;
  EXPECT_FALSE(air.innermost());
  const Media glass = air.entered(7, scene::Role::Virtual),
              bubble = glass.entered(9, scene::Role::Virtual);
  EXPECT_EQ(bubble.innermost(), 9u);
  EXPECT_EQ(bubble.left(9).innermost(), 7u);
  EXPECT_FALSE(bubble.left(9).left(7).innermost());
}

TEST(Media, LeavingAnOuterMediumKeepsTheInner) {
  EXPECT_EQ(
      Media().entered(1, scene::Role::Virtual).entered(2, scene::Role::Virtual).left(1).innermost(),
      2u);
}

TEST(Media, LeavingWhatWasNotEnteredChangesNothing) {
  EXPECT_FALSE(Media().left(3).innermost());
  EXPECT_EQ(Media().entered(1, scene::Role::Virtual).left(3).innermost(), 1u);
}

TEST(Media, TooDeepNestingForgetsTheOutermost) {
  Media media;
  for (std::uint32_t m = 0; m < 10; ++m) media = media.entered(m, scene::Role::Virtual);
  EXPECT_EQ(media.innermost(), 9u);
  for (std::uint32_t m = 9; m > 6; --m) media = media.left(m);
  EXPECT_EQ(media.innermost(), 6u);
  EXPECT_FALSE(media.left(6).innermost());
}

// Of a medium entered twice, with another between, the inner one is left.
TEST(Media, LeavingWhatWasEnteredTwiceKeepsTheOuter) {
  const Media left = Media()
                         .entered(1, scene::Role::Virtual)
                         .entered(2, scene::Role::Virtual)
                         .entered(1, scene::Role::Virtual)
                         .left(1);
  EXPECT_EQ(left.innermost(), 2u);
  EXPECT_EQ(left.left(2).innermost(), 1u);
}

}  // namespace
}  // namespace amalgam::trace
