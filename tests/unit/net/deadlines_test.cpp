#include "net/deadlines.h"

#include <gtest/gtest.h>

namespace amalgam::net {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using Passed = Deadlines::Passed;

const Deadlines::Time kStart = Deadlines::Time() + std::chrono::hours(1);

class DeadlinesTest : public testing::Test {
 protected:
  Deadlines deadlines_{SessionLimits{}, kStart};
};

TEST_F(DeadlinesTest, HelloMustBeCompleteHoweverSlowlyBytesArrive) {
  for (int i = 1; i < 4; ++i) {
    deadlines_.received_part(static_cast<std::size_t>(i), kStart + milliseconds(500 * i));
    EXPECT_FALSE(deadlines_.passed(kStart + milliseconds(500 * i)));
  }
  EXPECT_EQ(deadlines_.next(), kStart + seconds(2));
  EXPECT_EQ(deadlines_.passed(kStart + seconds(2)), Passed::Hello);
}

TEST_F(DeadlinesTest, SilenceEndsAfterTheIdleTimeout) {
  deadlines_.authenticated(kStart);
  EXPECT_FALSE(deadlines_.passed(kStart + milliseconds(4999)));
  EXPECT_EQ(deadlines_.passed(kStart + seconds(5)), Passed::Idle);
  deadlines_.received_message(kStart + seconds(4));
  EXPECT_FALSE(deadlines_.passed(kStart + milliseconds(8999)));
  EXPECT_EQ(deadlines_.passed(kStart + seconds(9)), Passed::Idle);
}

TEST_F(DeadlinesTest, PingsAreDueEachInterval) {
  deadlines_.authenticated(kStart);
  EXPECT_EQ(deadlines_.next(), kStart + seconds(1));
  EXPECT_FALSE(deadlines_.ping_due(kStart + milliseconds(999)));
  EXPECT_TRUE(deadlines_.ping_due(kStart + seconds(1)));
  EXPECT_FALSE(deadlines_.ping_due(kStart + seconds(1)));
  EXPECT_TRUE(deadlines_.ping_due(kStart + seconds(2)));
}

TEST_F(DeadlinesTest, ABodyAtOneKilobyteASecondIsTooSlow) {
  deadlines_.authenticated(kStart);
  deadlines_.received_part(1000, kStart);
  EXPECT_FALSE(deadlines_.passed(kStart + milliseconds(1999)));
  deadlines_.received_part(3000, kStart + seconds(2));
  EXPECT_EQ(deadlines_.passed(kStart + seconds(2)), Passed::SlowSender);
}

TEST_F(DeadlinesTest, AFastBodyMustStillEndInTime) {
  deadlines_.authenticated(kStart);
  deadlines_.received_part(1, kStart);
  deadlines_.received_part(1'000'000, kStart + milliseconds(4900));
  EXPECT_FALSE(deadlines_.passed(kStart + milliseconds(4999)));
  EXPECT_EQ(deadlines_.passed(kStart + seconds(5)), Passed::SlowSender);
}

TEST_F(DeadlinesTest, EachMessageHasItsOwnTime) {
  deadlines_.authenticated(kStart);
  deadlines_.received_part(100'000, kStart);
  // One read brings the rest of this message and more of the next than there was of this one.
  deadlines_.received_message(kStart + seconds(1));
  deadlines_.received_part(200'000, kStart + seconds(1));
  EXPECT_FALSE(deadlines_.passed(kStart + seconds(3)));
}

TEST_F(DeadlinesTest, AWriteThatIsNotTakenEvicts) {
  deadlines_.authenticated(kStart);
  deadlines_.write_begun(kStart);
  for (int s = 1; s < 5; ++s) {
    deadlines_.received_message(kStart + seconds(s));
    EXPECT_FALSE(deadlines_.passed(kStart + seconds(s)));
  }
  EXPECT_EQ(deadlines_.passed(kStart + seconds(5)), Passed::SlowReader);
  deadlines_.write_ended();
  EXPECT_FALSE(deadlines_.passed(kStart + seconds(5)));
}

// Once it is whole, nothing of a message is waited for, and silence counts from then on.
TEST_F(DeadlinesTest, AMessageThatHasEndedHasNoTime) {
  deadlines_.authenticated(kStart);
  deadlines_.received_part(100'000, kStart);
  deadlines_.received_message(kStart + seconds(1));
  deadlines_.received_part(0, kStart + seconds(1));
  EXPECT_FALSE(deadlines_.passed(kStart + milliseconds(5999)));
  EXPECT_EQ(deadlines_.passed(kStart + seconds(6)), Passed::Idle);
}

TEST_F(DeadlinesTest, NextIsTheEndOfAWriteIfThatComesFirst) {
  deadlines_.authenticated(kStart);
  deadlines_.write_begun(kStart);
  ASSERT_TRUE(deadlines_.ping_due(kStart + milliseconds(4500)));
  deadlines_.received_message(kStart + milliseconds(4500));
  EXPECT_EQ(deadlines_.next(), kStart + seconds(5));
  deadlines_.write_ended();
  EXPECT_EQ(deadlines_.next(), kStart + milliseconds(5500));
}

TEST_F(DeadlinesTest, NextLiesAheadWhileNothingHasPassed) {
  deadlines_.authenticated(kStart);
  deadlines_.received_part(10'000'000, kStart);  // begun: silence is not judged, progress is
  deadlines_.write_begun(kStart);
  for (auto now = kStart; !deadlines_.passed(now); now += milliseconds(10)) {
    deadlines_.ping_due(now);
    EXPECT_GT(deadlines_.next(), now);
  }
}

}  // namespace
}  // namespace amalgam::net
