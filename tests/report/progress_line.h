// How far a long run is, on standard error: one line that is rewritten on a terminal, a line every
// few seconds elsewhere.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

namespace amalgam::report {

// "12 of 40, about 3 min left" after that time; without an estimate before the first step.
std::string progress_text(int done, int all, std::chrono::duration<double> elapsed);

class ProgressLine {
 public:
  explicit ProgressLine(int steps);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // A step begins, or goes on with something else.
  void say(const std::string& what);
  void step_done() { ++done_; }
  // A step that was done in an earlier run: it does not count for the estimate.
  void step_skipped() { --steps_; }
  // A line that stays.
  void note(const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;

  void clear_line();

  int steps_, done_ = 0;
  bool terminal_;
  bool line_open_ = false;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_{};
};

}  // namespace amalgam::report
