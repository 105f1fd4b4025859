#include "net/read_pings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <utility>

namespace amalgam::net {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const ReadPings::Time kStart = ReadPings::Time() + std::chrono::hours(1);

TEST(ReadPings, APongTellsOfAllCompositesBeforeIt) {
  ReadPings pings;
  const auto first = pings.after_composite(kStart);
  const auto second = pings.after_composite(kStart + seconds(1));
  const auto third = pings.after_composite(kStart + seconds(2));
  EXPECT_LT(first, second);
  EXPECT_LT(second, third);
  EXPECT_EQ(pings.unread_since(), kStart);
  pings.heard_pong(second, kStart + seconds(3));
  EXPECT_EQ(pings.unread_since(), kStart + seconds(2));
  pings.heard_pong(third, kStart + seconds(3));
  EXPECT_EQ(pings.unread_since(), std::nullopt);
}

TEST(ReadPings, OtherPingsSayNothingOfLaterComposites) {
  ReadPings pings;
  const auto idle = pings.next(kStart);
  EXPECT_EQ(pings.unread_since(), std::nullopt);
  pings.after_composite(kStart + seconds(1));
  pings.heard_pong(idle, kStart + seconds(2));
  EXPECT_EQ(pings.unread_since(), kStart + seconds(1));
  EXPECT_FALSE(pings.may_write_composite());
}

// Also where somebody answers some pings only: what was not answered was not timed.
TEST(ReadPings, ALateAnswerIsNotTheRoundTripOfAnEarlierPing) {
  ReadPings pings;
  pings.next(kStart);
  pings.heard_pong(pings.next(kStart + seconds(1)), kStart + seconds(2));
  for (int i = 3; i < 6; ++i) {
    const auto written = kStart + seconds(i);
    pings.heard_pong(pings.after_composite(written), written + milliseconds(100));
  }
  pings.after_composite(kStart + seconds(6));
  EXPECT_FALSE(pings.may_write_composite());  // two seconds would allow another one
}

// A line with a delay and a rate: what is written goes over it one after the other.
class ReadPingsOnALine : public testing::Test {
 protected:
  // Writes composites while that is allowed, then lets the oldest be read. Returns how many are on
  // their way at most.
  int most_on_their_way(milliseconds round_trip, milliseconds transfer, int composites) {
    pings_.heard_pong(pings_.next(now_), now_ + round_trip);
    now_ += round_trip;
    ReadPings::Time line_free = now_;
    std::deque<std::pair<std::uint64_t, ReadPings::Time>> arrivals;
    std::size_t most = 0;
    for (int i = 0; i < composites; ++i) {
      while (pings_.may_write_composite() && arrivals.size() < 100) {
        line_free = std::max(line_free, now_) + transfer;
        arrivals.emplace_back(pings_.after_composite(now_), line_free + round_trip);
      }
      most = std::max(most, arrivals.size());
      now_ = arrivals.front().second;
      pings_.heard_pong(arrivals.front().first, now_);
      arrivals.pop_front();
    }
    return static_cast<int>(most);
  }

  ReadPings pings_;
  ReadPings::Time now_ = kStart;
};

TEST_F(ReadPingsOnALine, ASlowLineHasOneOnItsWay) {
  EXPECT_EQ(most_on_their_way(milliseconds(1), milliseconds(100), 20), 1);
}

TEST_F(ReadPingsOnALine, ALongLineHasTwoOnTheirWay) {
  EXPECT_EQ(most_on_their_way(milliseconds(200), milliseconds(20), 20), 2);
}

TEST(ReadPings, WithoutARoundTripAloneTheSecondWaits) {
  ReadPings pings;
  for (int i = 0; i < 3; ++i) {
    const auto written = kStart + seconds(i);
    pings.heard_pong(pings.after_composite(written), written + milliseconds(100));
  }
  pings.after_composite(kStart + seconds(3));
  EXPECT_FALSE(pings.may_write_composite());
}

TEST_F(ReadPingsOnALine, AReaderThatPausedGetsTwoAgain) {
  EXPECT_EQ(most_on_their_way(milliseconds(200), milliseconds(20), 5), 2);
  EXPECT_EQ(most_on_their_way(milliseconds(200), milliseconds(2000), 3), 2);
  EXPECT_EQ(most_on_their_way(milliseconds(200), milliseconds(2000), 3), 1);
  most_on_their_way(milliseconds(200), milliseconds(20), 3);
  EXPECT_EQ(most_on_their_way(milliseconds(200), milliseconds(20), 3), 2);
}

}  // namespace
}  // namespace amalgam::net
