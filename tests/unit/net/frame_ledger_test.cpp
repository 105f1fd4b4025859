#include "net/frame_ledger.h"

#include <gtest/gtest.h>

namespace amalgam::net {
namespace {

FrameLedger::Entry entry(std::uint64_t number) {
  FrameLedger::Entry entry;
  entry.ticket = number;
  entry.frame_id = 100 + number;
  return entry;
}

TEST(FrameLedger, EveryFrameIsAnsweredInFlightOrSkipped) {
  Metrics metrics;
  FrameLedger ledger(metrics);
  ledger.submit(entry(ledger.receive(10)), false);  // renders
  ledger.submit(entry(ledger.receive(10)), false);  // waits
  ledger.submit(entry(ledger.receive(10)), true);   // replaces the one that waits
  EXPECT_EQ(ledger.received_count(), 3u);
  EXPECT_EQ(ledger.skipped_count(), 1u);
  EXPECT_EQ(ledger.in_flight(), 2u);
  EXPECT_FALSE(ledger.deliver(2));
  const auto first = ledger.deliver(1);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->frame_id, 101u);
  EXPECT_FALSE(ledger.deliver(1));
  ledger.sent(50);
  ledger.abandon();
  EXPECT_EQ(ledger.in_flight(), 0u);
  EXPECT_EQ(ledger.sent_count() + ledger.skipped_count(), ledger.received_count());
}

// One that renders, one that waits, and one whose result is on its way here.
TEST(FrameLedger, AllThatIsAbandonedCounts) {
  Metrics metrics;
  FrameLedger ledger(metrics);
  for (int i = 0; i < 3; ++i) ledger.submit(entry(ledger.receive(10)), false);
  ledger.abandon();
  EXPECT_EQ(ledger.skipped_count(), 3u);
  EXPECT_NE(metrics.text({}).find("amalgam_frames_skipped_total{reason=\"closed\"} 3"),
            std::string::npos);
}

}  // namespace
}  // namespace amalgam::net
