#include "net/metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace amalgam::net {
namespace {

using testing::HasSubstr;

Gauges dropped(std::uint64_t lines) {
  Gauges gauges;
  gauges.dropped_log_lines = lines;
  return gauges;
}

TEST(Metrics, TextNamesWhatWasCounted) {
  Metrics metrics;
  metrics.session_opened();
  metrics.refused("address");
  metrics.error_sent(protocol::Error::POSE_REJECTED);
  metrics.frame_received(1000);
  metrics.frame_skipped(Skip::ReplacedBeforeRender, 2);
  metrics.composite_sent(500);
  frame::FrameOutput output;
  output.unchanged = true;
  output.statistics.stages = {{"trace", 3.0}};
  output.statistics.passes = {{"composite", true, ""}, {"warp", false, "no lens distortion"}};
  output.statistics.rays.shadow = 9;
  output.statistics.nonfinite = 4;
  output.statistics.quality = {.level = 3, .bound = frame::FrameQuality::Bound::Trace};
  metrics.frame_rendered(output, 20.0);

  const std::string text = metrics.text({});
  // By type: rates of a gauge would be taken for changes of state.
  EXPECT_THAT(text, HasSubstr("# TYPE process_cpu_seconds_total counter"));
  EXPECT_THAT(text, HasSubstr("# TYPE amalgam_log_lines_dropped_total counter"));
  EXPECT_THAT(metrics.text(dropped(3)), HasSubstr("lines_dropped_total 3"));
  EXPECT_THAT(metrics.text(dropped(5)), HasSubstr("lines_dropped_total 5"));
  for (const char* line :
       {"amalgam_sessions 1", "amalgam_refusals_total{reason=\"address\"} 1",
        "amalgam_errors_total{code=\"POSE_REJECTED\"} 1", "amalgam_frames_received_total 1",
        "amalgam_frames_skipped_total{reason=\"replaced_before_render\"} 2",
        "amalgam_frames_sent_total 1", "amalgam_composite_bytes_sent_total 500",
        "amalgam_stage_seconds_bucket{stage=\"trace\",le=\"0.004\"} 1",
        "amalgam_stage_seconds_bucket{stage=\"trace\",le=\"0.002\"} 0",
        "amalgam_frame_seconds_count 1", "amalgam_rays_total{kind=\"shadow\"} 9",
        "amalgam_passes_run_total{pass=\"composite\"} 1", "amalgam_nonfinite_total 4",
        "amalgam_frames_unchanged_total 1", "amalgam_quality_level_sum{bound=\"trace\"} 3"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
  EXPECT_THAT(text, Not(HasSubstr("warp")));
}

}  // namespace
}  // namespace amalgam::net
