#include "client/summary.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

#include "client/tracking/poses_file.h"

namespace amalgam::client {
namespace {

constexpr double kMilli = 1e3;
constexpr double kDegree = std::numbers::pi / 180.0;

std::string smoothing_text(const tracking::SmoothingReport& report) {
  char text[240];
  std::snprintf(text, sizeof text,
                "smoothing  jitter %.3f -> %.3f mm, %.3f -> %.3f degrees; lag %.0f ms in position, "
                "%.0f ms in rotation\n",
                report.position.raw_jitter * kMilli, report.position.smoothed_jitter * kMilli,
                report.rotation.raw_jitter / kDegree, report.rotation.smoothed_jitter / kDegree,
                report.position.lag * kMilli, report.rotation.lag * kMilli);
  return text;
}

nlohmann::ordered_json smoothing_json(const std::optional<tracking::SmoothingReport>& report) {
  if (!report) return nullptr;
  return {{"poses", report->poses},
          {"position",
           {{"jitter_mm", report->position.raw_jitter * kMilli},
            {"smoothed_jitter_mm", report->position.smoothed_jitter * kMilli},
            {"lag_ms", report->position.lag * kMilli}}},
          {"rotation",
           {{"jitter_degrees", report->rotation.raw_jitter / kDegree},
            {"smoothed_jitter_degrees", report->rotation.smoothed_jitter / kDegree},
            {"lag_ms", report->rotation.lag * kMilli}}}};
}

}  // namespace

std::string summary_text(const ViewerSummary& summary) {
  const FrameCounts& frames = summary.frames;
  const auto number = [](std::uint64_t value) { return std::to_string(value); };
  char latency[120];
  std::snprintf(latency, sizeof latency, "latency    median %.1f ms, p95 %.1f ms, p99 %.1f ms",
                summary.latency.median, summary.latency.p95, summary.latency.p99);
  std::string text = "frames     " + number(frames.captured) + " captured, " +
                     number(frames.composited) + " composited (" + number(frames.unchanged) +
                     " unchanged), " + number(frames.skipped_by_client) + " skipped here, " +
                     number(frames.skipped_by_server) + " skipped by the server, " +
                     number(frames.rejected) + " rejected, " + number(frames.lost) + " lost\n";
  text += std::string(latency) + " (capture to composite)\n";
  text += "markers    " + number(summary.markers.poses) + " poses in " +
          number(summary.markers.images) + " images, " + number(summary.markers.repeated) +
          " repeated, " + number(summary.markers.unsolved) + " unsolved";
  if (summary.poses_held > 0) text += "; " + number(summary.poses_held) + " held by the dead band";
  if (summary.markers.board_poses + summary.markers.board_outliers > 0) {
    text += "; board seen in " + number(summary.markers.board_poses) + " images, " +
            number(summary.markers.board_outliers) + " of its markers left out";
  }
  text += "\n";
  if (summary.smoothing) text += smoothing_text(*summary.smoothing);
  text += "connection " + number(summary.reconnects) + " reconnects, " +
          number(summary.server_errors) + " errors";
  if (!summary.last_error.empty()) text += ", last: " + summary.last_error;
  return text + "\n";
}

std::string summary_json(const ViewerSummary& summary) {
  const FrameCounts& frames = summary.frames;
  const nlohmann::ordered_json json{{"frames",
                                     {{"captured", frames.captured},
                                      {"composited", frames.composited},
                                      {"unchanged", frames.unchanged},
                                      {"skipped_by_client", frames.skipped_by_client},
                                      {"skipped_by_server", frames.skipped_by_server},
                                      {"rejected", frames.rejected},
                                      {"lost", frames.lost}}},
                                    {"latency_ms",
                                     {{"median", summary.latency.median},
                                      {"p95", summary.latency.p95},
                                      {"p99", summary.latency.p99}}},
                                    {"markers",
                                     {{"images", summary.markers.images},
                                      {"poses", summary.markers.poses},
                                      {"repeated", summary.markers.repeated},
                                      {"unsolved", summary.markers.unsolved},
                                      {"board_images", summary.markers.board_poses},
                                      {"board_outliers", summary.markers.board_outliers}}},
                                    {"poses_held", summary.poses_held},
                                    {"poses", poses_json(summary.last_poses)},
                                    {"smoothing", smoothing_json(summary.smoothing)},
                                    {"reconnects", summary.reconnects},
                                    {"server_errors", summary.server_errors},
                                    {"last_error", summary.last_error},
                                    {"seconds", summary.seconds}};
  // Texts come from the server: bytes that are no UTF-8 must not end the program.
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace amalgam::client
