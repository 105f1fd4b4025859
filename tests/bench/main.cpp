// amalgam-bench: whether the goals for speed and memory are met; or micro-benchmarks.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "bench/bench_options.h"
#include "bench/goal_report.h"
#include "bench/goals/goal_list.h"
#include "bench/micro/micro_benchmarks.h"
#include "bench/progress.h"
#include "bench/two_cores.h"
#include "common/log.h"

namespace amalgam::bench {
namespace {

bool is_wanted(const std::string& name, const std::vector<std::string>& only) {
  return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
}

void check_names(const std::vector<std::string>& only) {
  for (const std::string& name : only) {
    const auto& goals = all_goals();
    if (std::none_of(goals.begin(), goals.end(),
                     [&](const MeasuredGoal& entry) { return entry.goal.name == name; })) {
      throw std::invalid_argument("there is no goal '" + name + "'; see --list");
    }
  }
}

bool has_failed(const GoalLine& line) {
  const auto* missing = std::get_if<NotMeasured>(&line.outcome);
  return missing != nullptr && missing->failed;
}

void run_goals(const BenchOptions& options) {
  check_names(options.only);
  const int cores = keep_to_two_cores();
  common::set_log_level("warn");
  GoalBench bench(options.scenes, cores);
  if (!options.json) print_head(std::cout, cores);
  GoalReport report{.cores = cores, .lines = {}, .thesis = {}};
  for (const MeasuredGoal& goal : all_goals()) {
    if (!is_wanted(goal.goal.name, options.only)) continue;
    report.lines.push_back(measure(goal, bench));
    if (!options.json) print_line(std::cout, report.lines.back());
    std::cout.flush();
  }
  say_progress("done");
  report.thesis = bench.measured_thesis();
  if (options.json) {
    print_json(std::cout, report);
  } else {
    print_thesis(std::cout, report.thesis);
  }
  if (std::any_of(report.lines.begin(), report.lines.end(), has_failed)) {
    throw std::runtime_error("not all goals could be measured");
  }
}

void run_benchmarks(BenchOptions& options) {
  std::string filter = "--benchmark_filter=^(";
  for (const std::string& name : options.only) {
    filter += (name == options.only.front() ? "" : "|") + name;
  }
  filter += ")$";
  auto& arguments = options.benchmark_arguments;
  if (!options.only.empty()) arguments.push_back(filter.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) {
    throw std::invalid_argument("see --help");
  }
  if (benchmark::RunSpecifiedBenchmarks() == 0) {
    throw std::invalid_argument("no benchmark of that name; see --list");
  }
}

void print_list() {
  std::cout << "goals:\n";
  for (const MeasuredGoal& entry : all_goals()) {
    std::cout << "  " << entry.goal.name << ": " << entry.goal.what << '\n';
  }
  std::cout << "benchmarks:\n";
  for (const char* name : micro_benchmark_names()) std::cout << "  " << name << '\n';
}

void run(BenchOptions& options) {
  register_micro_benchmarks(options.scenes);
  if (options.list) {
    print_list();
  } else if (options.goals) {
    run_goals(options);
  } else {
    run_benchmarks(options);
  }
}

}  // namespace
}  // namespace amalgam::bench

int main(int argc, char** argv) {
  try {
    auto options = amalgam::bench::parse_bench_options(argc, argv);
    if (options) amalgam::bench::run(*options);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "amalgam-bench: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
