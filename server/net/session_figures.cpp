#include "net/session_figures.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace amalgam::net {
namespace {

// The value that a part of all do not exceed (nearest rank). values: sorted, not empty.
double quantile(std::span<const float> values, double part) {
  const double rank = std::ceil(part * static_cast<double>(values.size()));
  return static_cast<double>(values[static_cast<std::size_t>(std::max(rank, 1.0)) - 1]);
}

}  // namespace

void SessionFigures::rendered(const frame::FrameOutput& output, double server_ms) {
  const frame::FrameStatistics& statistics = output.statistics;
  server_ms_[rendered_++ % server_ms_.size()] = static_cast<float>(server_ms);
  if (output.unchanged) ++unchanged_;
  stages_ = statistics.stages;
  // Seldom different from the last frame's, and long.
  if (passes_ != statistics.passes) passes_ = statistics.passes;
  quality_ = statistics.quality;
}

void SessionFigures::fill(SessionReport& report, Time now) const {
  report.frames_asked_per_second = asked_.rate(now);
  report.frames_served_per_second = served_.rate(now);
  report.unchanged = unchanged_;
  report.stages = stages_;
  report.passes = passes_;
  report.quality = quality_;
  if (rendered_ == 0) return;
  std::array<float, 256> sorted = server_ms_;
  const auto count = std::min<std::uint64_t>(rendered_, sorted.size());
  const std::span<float> values = std::span(sorted).first(count);
  std::sort(values.begin(), values.end());
  report.server_ms = {.median = quantile(values, 0.5), .p99 = quantile(values, 0.99)};
}

}  // namespace amalgam::net
