// Wall-clock times of named stages of one frame.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace amalgam::core {

struct StageTime {
  std::string stage;
  double milliseconds = 0.0;
};

using StageTimes = std::vector<StageTime>;

// Adds to the stage's entry, or makes one: a stage that runs twice in a frame is reported once.
void add_time(StageTimes& times, const std::string& stage, double milliseconds);

class Stopwatch {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace amalgam::core
