// Memory: pages that a frame touches for the first time, and what a session keeps.
#include <cmath>

#include "bench/child_server.h"
#include "bench/goals/measures.h"
#include "bench/page_faults.h"
#include "bench/render_rig.h"
#include "bench/streaming_session.h"

namespace amalgam::bench {
namespace {

constexpr int kFramesToSteady = 4;
constexpr int kFrames = 5;
constexpr int kFurtherSessions = 3;

}  // namespace

Outcome measure_page_faults(GoalBench& bench) {
  const BenchCase bunny = bench.scenes().glass_bunny(1280, 1024);
  RenderRig rig(bunny, default_settings());
  for (int i = 1; i < kFramesToSteady; ++i) rig.render();
  std::vector<double> faults;
  for (int i = 0; i < kFrames; ++i) {
    const long before = minor_page_faults();
    rig.render();
    faults.push_back(static_cast<double>(minor_page_faults() - before));
  }
  const Ratio ratio = ratio_of_rounds(faults, std::vector<double>(faults.size(), 1.0));
  return to_measurement(ratio, bunny.name + ": median of " + std::to_string(kFrames) +
                                   " frames after " + std::to_string(kFramesToSteady));
}

// In a process of its own, whose allocator holds nothing back from earlier measurements.
Outcome measure_session_memory(GoalBench& bench) {
  if (!ChildServer::is_built()) return NotMeasured{"amalgam-server is not built"};
  const BenchCase complex = bench.scenes().complex(1280, 1024);
  ChildServer server(complex.scene_path);
  StreamingSession first(server.address(), complex);
  first.wait_for(kFramesToSteady);
  std::vector<double> megabytes;
  std::vector<std::unique_ptr<StreamingSession>> further;
  double before = server.resident_megabytes();
  for (int i = 0; i < kFurtherSessions; ++i) {
    further.push_back(std::make_unique<StreamingSession>(server.address(), complex));
    further.back()->wait_for(2);
    const double after = server.resident_megabytes();
    megabytes.push_back(after - before);
    before = after;
  }
  Ratio ratio = ratio_of_rounds(megabytes, std::vector<double>(megabytes.size(), 1.0));
  double sum = 0.0;
  for (const double each : megabytes) sum += each;
  ratio.value = sum / kFurtherSessions;
  return to_measurement(ratio, complex.name + ": mean of " + std::to_string(kFurtherSessions) +
                                   " further sessions, server of " +
                                   std::to_string(std::lround(before)) + " MB at the end");
}

}  // namespace amalgam::bench
