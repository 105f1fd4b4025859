// amalgam-inspect: the contents of a scene, as the renderer takes it.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

#include "client/tools/inspect/inspect_report.h"
#include "client/tools/marker/scene_markers.h"
#include "common/build_info.h"
#include "common/parse_command_line.h"
#include "common/run_program.h"
#include "scene/gltf/loader.h"
#include "sheet/sheet_file.h"

namespace {

struct Options {
  std::string scene;
  std::string environment;
  std::string env_lights = "sectors";
  std::string marker_sheet;
  std::string paper = "A4";
  bool json = false;
};

using namespace amalgam;

// The chosen extraction first, then the usual ones.
std::vector<tools::Inspection::LightError> light_errors(const scene::Environment& environment,
                                                        const std::string& chosen) {
  std::vector<std::string> choices{chosen};
  for (const char* usual :
       {"sectors", "median-cut:8", "median-cut:32", "median-cut:128", "median-cut:512"}) {
    if (usual != chosen) choices.emplace_back(usual);
  }
  std::vector<tools::Inspection::LightError> errors;
  for (const std::string& choice : choices) {
    const auto lights = scene::extract_lights(environment, scene::parse_env_light_options(choice));
    errors.push_back({choice, lights.size(), scene::irradiance_error(environment, lights)});
  }
  return errors;
}

void write_markers(const Options& options, const scene::Scene& scene) {
  sheet::SheetOptions wanted = tools::markers_of(scene);
  wanted.title = std::filesystem::path(options.scene).filename().string();
  sheet::set_paper(wanted, options.paper == "A4" ? "a4" : options.paper);
  sheet::write_sheet(options.marker_sheet, sheet::lay_out_markers(wanted));
}

void inspect(const Options& options) {
  const auto light_options = scene::parse_env_light_options(options.env_lights);
  scene::LoadOptions load_options;
  if (!options.environment.empty()) load_options.environment = options.environment;
  tools::Inspection inspection;
  inspection.scene = scene::load_scene(options.scene, load_options);
  if (!options.marker_sheet.empty()) return write_markers(options, inspection.scene);
  if (const auto& environment = inspection.scene.environment) {
    inspection.environment_lights = scene::extract_lights(*environment, light_options);
    inspection.light_errors = light_errors(*environment, to_string(light_options));
  }
  (options.json ? tools::print_json : tools::print_text)(std::cout, inspection);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Shows what is in a scene: role, marker and material of every node, the lights, and "
      "what every frame will leave out. Lengths are in metres.");
  Options options;
  app.add_option("scene", options.scene, "glTF 2.0 scene (.gltf or .glb)")->required();
  app.add_option("--environment", options.environment,
                 "environment map instead of the scene's own (.exr, .hdr, .jpg, .png)");
  app.add_option("--env-lights", options.env_lights,
                 "how the environment becomes lights: sectors or median-cut:N")
      ->capture_default_str();
  app.add_option("--marker-sheet", options.marker_sheet,
                 "instead, write the scene's markers to print at true size (.pdf; .svg if one page "
                 "is enough)")
      ->type_name("FILE");
  app.add_option("--paper", options.paper, "of the marker sheet")
      ->check(CLI::IsMember({"A4", "letter"}))
      ->capture_default_str();
  app.add_flag("--json", options.json, "print one JSON object");
  app.set_version_flag("--version", common::version_line("amalgam-inspect"));
  return common::run_program("amalgam-inspect", [&] {
    if (!common::parse_command_line(app, argc, argv)) return 0;
    inspect(options);
    return 0;
  });
}
