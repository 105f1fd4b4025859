#include "net/environment_slot.h"

#include <gtest/gtest.h>

namespace amalgam::net {
namespace {

frame::EnvironmentInput image_of(std::size_t bytes) {
  frame::EnvironmentInput input;
  input.image.resize(bytes);
  return input;
}

TEST(EnvironmentSlot, OneIsAppliedAndTheNewestWaits) {
  EnvironmentSlot slot;
  auto offered = slot.offer(image_of(1));
  ASSERT_TRUE(offered.now);
  EXPECT_EQ(offered.now->image.size(), 1u);
  offered = slot.offer(image_of(2));
  EXPECT_FALSE(offered.now);
  EXPECT_FALSE(offered.replaced);
  offered = slot.offer(image_of(3));
  EXPECT_FALSE(offered.now);
  EXPECT_TRUE(offered.replaced);

  const auto next = slot.done();
  ASSERT_TRUE(next);
  EXPECT_EQ(next->image.size(), 3u);
  EXPECT_FALSE(slot.offer(image_of(4)).now);  // 3 is still being applied
  EXPECT_TRUE(slot.done());
  EXPECT_FALSE(slot.done());
  EXPECT_TRUE(slot.offer(image_of(5)).now);
}

}  // namespace
}  // namespace amalgam::net
