#include "net/session_figures.h"

#include <gtest/gtest.h>

namespace amalgam::net {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using Time = EventRate::Time;

const Time kStart = Time() + std::chrono::hours(1);

TEST(EventRate, IsThatOfTheLastSeconds) {
  EventRate rate;
  EXPECT_EQ(rate.rate(kStart), 0.0);
  Time now = kStart;
  for (int i = 0; i < 100; ++i) rate.happened(now += milliseconds(100));
  EXPECT_NEAR(rate.rate(now), 10.0, 0.3);
  // It stops, and after the window nothing is left.
  EXPECT_NEAR(rate.rate(now + milliseconds(2500)), 5.0, 0.3);
  EXPECT_EQ(rate.rate(now + seconds(5)), 0.0);
}

TEST(EventRate, OfAYoungSessionCountsFromItsFirstEvent) {
  EventRate rate;
  rate.happened(kStart);
  EXPECT_EQ(rate.rate(kStart), 1.0);  // and not without end
  for (int i = 1; i <= 20; ++i) rate.happened(kStart + milliseconds(100 * i));
  EXPECT_NEAR(rate.rate(kStart + seconds(2)), 10.0, 0.6);
}

// More often than it remembers: 256 events take a quarter of a second.
TEST(EventRate, OfAFloodIsNotLost) {
  EventRate rate;
  Time now = kStart;
  for (int i = 0; i < 3000; ++i) rate.happened(now += milliseconds(1));
  EXPECT_NEAR(rate.rate(now), 1000.0, 10.0);
}

frame::FrameOutput output(double trace_ms) {
  frame::FrameOutput output;
  output.unchanged = trace_ms > 2.0;
  output.statistics.stages = {{"trace", trace_ms}};
  output.statistics.passes = {{"warp", false, "no lens distortion"}};
  return output;
}

TEST(SessionFigures, TimesAreOfTheLastFrames) {
  SessionFigures figures;
  SessionReport report;
  figures.fill(report, kStart);
  EXPECT_FALSE(report.server_ms);
  for (int i = 1; i <= 100; ++i) figures.rendered(output(1.0), static_cast<double>(i));
  figures.fill(report, kStart);
  ASSERT_TRUE(report.server_ms);
  EXPECT_EQ(report.server_ms->median, 50.0);
  EXPECT_EQ(report.server_ms->p99, 99.0);
  EXPECT_EQ(report.unchanged, 0u);
  // 256 others push all of these out.
  for (int i = 0; i < 256; ++i) figures.rendered(output(3.0), 7.0);
  figures.fill(report, kStart);
  EXPECT_EQ(report.server_ms->median, 7.0);
  EXPECT_EQ(report.server_ms->p99, 7.0);
  EXPECT_EQ(report.unchanged, 256u);
  ASSERT_EQ(report.stages.size(), 1u);
  EXPECT_EQ(report.stages[0].milliseconds, 3.0);
  ASSERT_EQ(report.passes.size(), 1u);
  EXPECT_EQ(report.passes[0].reason, "no lens distortion");
}

}  // namespace
}  // namespace amalgam::net
