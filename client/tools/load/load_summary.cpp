#include "client/tools/load/load_summary.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "common/nearest_rank.h"

namespace amalgam::load {
std::string to_json(LoadSummary summary) {
  std::sort(summary.latencies_ms.begin(), summary.latencies_ms.end());
  std::vector<double> due;
  for (const LoadSummary::Due& frame : summary.due) due.push_back(frame.latency);
  std::sort(due.begin(), due.end());
  const nlohmann::ordered_json json = {
      {"clients", summary.clients},
      {"welcomed", summary.welcomed},
      {"lost", summary.lost},
      {"sent", summary.sent},
      {"unsent", summary.unsent},
      {"composited", summary.composited},
      {"unchanged", summary.unchanged},
      {"skipped", summary.skipped},
      {"errors", summary.errors},
      {"latency_ms",
       {{"median", common::nearest_rank(summary.latencies_ms, 0.5)},
        {"p95", common::nearest_rank(summary.latencies_ms, 0.95)},
        {"p99", common::nearest_rank(summary.latencies_ms, 0.99)}}},
      {"due_latency_ms",
       {{"median", common::nearest_rank(due, 0.5)},
        {"p95", common::nearest_rank(due, 0.95)},
        {"p99", common::nearest_rank(due, 0.99)},
        {"most", common::nearest_rank(due, 1.0)}}},
      {"unanswered", summary.unanswered},
      {"bytes_sent", summary.bytes_sent},
      {"bytes_received", summary.bytes_received},
      {"seconds", summary.seconds}};
  return json.dump(2);
}

}  // namespace amalgam::load
