#include "report/report_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "common/build_info.h"
#include "common/parse_command_line.h"
#include "report/report_scene.h"
#include "report/sweeps.h"
#include "server/renderer_options.h"

namespace amalgam::report {
namespace {

constexpr const char* kFooter =
    "Writes runs.csv (a row a run), summary.csv (a row a setting) and report.html (one file, no "
    "network) to the output folder. Errors are mean absolute differences of display-linear light "
    "(1 is white) to a reference in double precision; times are milliseconds a frame.\n"
    "Cut off, the same command goes on where it ended. The full sweep takes hours, --quick "
    "minutes. Charts need gnuplot (apt-get install gnuplot-nox), the bunnies "
    "deploy/fetch_assets.sh bunny.";

constexpr glm::ivec2 kQuickSize{80, 60}, kFullSize{320, 240};
constexpr RunPlan kQuickPlan{.runs = 4, .places = 2}, kFullPlan{.runs = 20, .places = 5};

glm::ivec2 parse_size(const std::string& text) {
  int width = 0, height = 0, read = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &read) != 2 ||
      static_cast<std::size_t>(read) != text.size() || width < 16 || height < 16 || width > 2048 ||
      height > 2048) {
    throw std::invalid_argument("--size: '" + text + "' is not WxH, each from 16 to 2048 pixels");
  }
  return {width, height};
}

void check_names(const char* option, const std::vector<std::string>& names,
                 const std::vector<std::string>& known) {
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    std::string all;
    for (const std::string& one : known) all += (all.empty() ? "" : ", ") + one;
    throw std::invalid_argument(std::string(option) + ": '" + name + "' is none of " + all);
  }
}

std::vector<std::string> scene_names(const std::string& folder) {
  std::vector<std::string> names;
  for (const ReportScene& scene : report_scenes(folder, false)) names.push_back(scene.name);
  return names;
}

}  // namespace

bool ReportOptions::wants(const std::string& part) const {
  return parts.empty() || std::find(parts.begin(), parts.end(), part) != parts.end();
}

std::optional<ReportOptions> parse_report_options(int argc, char** argv) {
  ReportOptions options;
  // The default scene lies beside the others.
  options.scenes = std::filesystem::path(tools::default_scene_path()).parent_path().string();
  std::string size;
  int runs = 0;
  CLI::App app("Error against run time of Amalgam's renderer.", "amalgam-report");
  app.footer(kFooter);
  app.set_version_flag("--version", common::version_line("amalgam-report"));
  app.add_option("--output", options.output, "folder for the report; made if it is not there")
      ->required();
  app.add_flag("--quick", options.quick, "fewer settings and runs, small pictures");
  app.add_option("--references", options.references,
                 "folder that keeps reference pictures [OUTPUT/references]");
  app.add_option("--scenes", options.scenes,
                 "folder with complex.gltf, glassware.gltf and generated/bunny-{glass,mirror}.gltf")
      ->capture_default_str();
  app.add_option("--only", options.only, "only this scene, as 'glass bunny'; may be repeated");
  app.add_option("--sweep", options.sweeps, "only this sweep, as samples; may be repeated");
  app.add_option(
      "--part", options.parts,
      "only this part: sweeps, jitter, determinism, table-6.1 or truth; may be repeated");
  app.add_option("--size", size, "size of the pictures, pixels [320x240; quick: 80x60]");
  app.add_option("--runs", runs, "runs of each setting, 1 to 1000 [20; quick: 4]")
      ->check(common::in_range(1, 1000));
  app.add_option("--threads", options.threads, "rendering threads, 1 to 64 [one for each core]")
      ->check(common::in_range(1, 64));
  if (!common::parse_command_line(app, argc, argv)) return std::nullopt;
  options.size = size.empty() ? (options.quick ? kQuickSize : kFullSize) : parse_size(size);
  options.plan = options.quick ? kQuickPlan : kFullPlan;
  if (runs > 0) options.plan.runs = runs;
  options.plan.places = std::min(options.plan.places, options.plan.runs);
  if (options.references.empty()) {
    options.references = (std::filesystem::path(options.output) / "references").string();
  }
  check_names("--only", options.only, scene_names(options.scenes));
  check_names("--sweep", options.sweeps, sweep_names());
  check_names("--part", options.parts,
              {kSweepPart, kJitterPart, kDeterminismPart, kTablePart, kTruthPart});
  return options;
}

}  // namespace amalgam::report
