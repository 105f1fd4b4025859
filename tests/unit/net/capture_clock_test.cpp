#include "net/capture_clock.h"

#include <gtest/gtest.h>

namespace amalgam::net {
namespace {

using std::chrono::milliseconds;
const CaptureClock::Time kStart{};

TEST(CaptureClock, SteadyTimesPass) {
  CaptureClock clock;
  for (std::uint64_t i = 0; i < 10; ++i) {
    const auto judged = clock.judge(i * 33'000, kStart + milliseconds(33 * i));
    EXPECT_EQ(judged.time_us, i * 33'000);
    EXPECT_FALSE(judged.clamped);
  }
}

TEST(CaptureClock, BackwardsIsClampedOnceAndNotForEver) {
  CaptureClock clock;
  clock.judge(5'000'000, kStart);
  const auto backwards = clock.judge(1'000, kStart + milliseconds(33));
  EXPECT_TRUE(backwards.clamped);
  EXPECT_EQ(backwards.time_us, 5'000'000u);
  const auto next = clock.judge(34'000, kStart + milliseconds(66));
  EXPECT_FALSE(next.clamped);
  EXPECT_EQ(next.time_us, 34'000u);
}

TEST(CaptureClock, FarAheadIsClampedToTheLead) {
  CaptureClock clock;
  clock.judge(0, kStart);
  const auto judged = clock.judge(UINT64_MAX, kStart + milliseconds(100));
  EXPECT_TRUE(judged.clamped);
  EXPECT_EQ(judged.time_us, 10'100'000u);  // 100 ms between arrivals and 10 s
}

TEST(CaptureClock, TheLargestTimeDoesNotOverflow) {
  CaptureClock clock;
  clock.judge(UINT64_MAX, kStart);
  EXPECT_EQ(clock.judge(UINT64_MAX, kStart + milliseconds(1)).time_us, UINT64_MAX);
}

}  // namespace
}  // namespace amalgam::net
