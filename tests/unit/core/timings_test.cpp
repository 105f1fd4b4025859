#include "core/timings.h"

#include <gtest/gtest.h>

#include <thread>

namespace amalgam::core {
namespace {

TEST(Timings, AStageThatRunsTwiceIsReportedOnce) {
  StageTimes times;
  add_time(times, "trace", 2.0);
  add_time(times, "encode", 1.0);
  add_time(times, "trace", 3.0);
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(times[0].stage, "trace");
  EXPECT_DOUBLE_EQ(times[0].milliseconds, 5.0);
  EXPECT_DOUBLE_EQ(times[1].milliseconds, 1.0);
}

TEST(Timings, TheStopwatchRuns) {
  const Stopwatch stopwatch;
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_GE(stopwatch.milliseconds(), 5.0);
  EXPECT_LT(stopwatch.milliseconds(), 5000.0);
}

}  // namespace
}  // namespace amalgam::core
