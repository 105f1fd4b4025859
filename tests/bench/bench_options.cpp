#include "bench/bench_options.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <stdexcept>

#include "common/build_info.h"
#include "common/parse_command_line.h"
#include "server/renderer_options.h"

namespace amalgam::bench {
namespace {

constexpr const char* kFooter =
    "Goals are ratios of two things measured by turns in one run; --goals takes minutes. The "
    "process "
    "keeps to two cores. It exits with 0 even if goals are not met.\n"
    "What may be missing: the bunnies (deploy/fetch_assets.sh bunny) and POV-Ray (apt-get install "
    "povray); what needs them is then 'not measured'.\n"
    "Without --goals the arguments are Google Benchmark's, as --benchmark_filter=intersect; a "
    "goal's "
    "or benchmark's name for --only is one that --list prints.";

constexpr std::string_view kBenchmarkPrefix = "--benchmark_";

}  // namespace

std::optional<BenchOptions> parse_bench_options(int argc, char** argv) {
  BenchOptions options;
  // The default scene lies beside what the bench needs.
  options.scenes = std::filesystem::path(tools::default_scene_path()).parent_path().string();
  CLI::App app("Measures Amalgam: its goals, or single hot functions.", "amalgam-bench");
  app.footer(kFooter);
  app.set_version_flag("--version", common::version_line("amalgam-bench"));
  app.add_flag("--goals", options.goals, "measure the goals and print a line for each");
  app.add_flag("--json", options.json, "print one JSON object instead (with --goals)");
  app.add_flag("--list", options.list, "print the names of goals and benchmarks");
  app.add_option("--only", options.only,
                 "only goals or benchmarks of these names; may be repeated");
  app.add_option("--scenes", options.scenes,
                 "folder with complex.gltf and generated/bunny-{glass,mirror}.gltf")
      ->capture_default_str();

  options.benchmark_arguments = {argv[0]};
  std::vector<std::string> ours;
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]).starts_with(kBenchmarkPrefix)) {
      options.benchmark_arguments.push_back(argv[i]);
    } else {
      ours.insert(ours.begin(), argv[i]);  // CLI takes them from the end
    }
  }
  if (!common::parse_command_line(app, [&] { app.parse(ours); })) return std::nullopt;
  if (options.json && !options.goals) {
    throw std::invalid_argument(
        "--json goes with --goals; benchmarks have --benchmark_format=json");
  }
  return options;
}

}  // namespace amalgam::bench
