// Measures Amalgam for rows of Table 6.1: times at the row's own size, errors at a smaller one.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_case.h"
#include "bench/thesis_result.h"
#include "frame/renderer_settings.h"

namespace amalgam::bench {

class ThesisMeter {
 public:
  // seconds: the time to spend on each frame rate, at most three times that.
  explicit ThesisMeter(const BenchScenes& scenes, double seconds = 3.0)
      : scenes_(scenes), seconds_(seconds) {}

  // Rows that differ only in what Amalgam does not tell apart are measured once.
  ThesisResult measure(const ThesisRow& row);

 private:
  struct Figures {
    double frames_per_second = 0.0;
    std::optional<double> still_frames_per_second;
    double error = 0.0;
  };

  const Figures& figures(const ThesisRow& row, const std::string& samples);
  double error(const ThesisRow& row, const std::string& samples);

  const BenchScenes& scenes_;
  double seconds_;
  std::map<std::string, Figures> figures_;
  std::map<std::string, common::ImageRgb8> references_;
};

}  // namespace amalgam::bench
