// amalgam-bench's command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace amalgam::bench {

struct BenchOptions {
  bool goals = false, json = false, list = false;
  std::vector<std::string> only;
  std::string scenes;                      // folder
  std::vector<char*> benchmark_arguments;  // argv[0] and what is Google Benchmark's
};

// Nothing if the program is to end (--help). Throws std::invalid_argument with one line.
std::optional<BenchOptions> parse_bench_options(int argc, char** argv);

}  // namespace amalgam::bench
