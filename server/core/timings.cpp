#include "core/timings.h"

#include <algorithm>

namespace amalgam::core {

void add_time(StageTimes& times, const std::string& stage, double milliseconds) {
  const auto found = std::find_if(times.begin(), times.end(),
                                  [&](const StageTime& entry) { return entry.stage == stage; });
  if (found == times.end()) {
    times.push_back({stage, milliseconds});
  } else {
    found->milliseconds += milliseconds;
  }
}

}  // namespace amalgam::core
