// amalgam-marker: a page of markers to print.
#include <CLI/CLI.hpp>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "client/tools/marker/marker_sheet.h"
#include "common/build_info.h"
#include "common/run_program.h"
#include "common/whole_file.h"
#include "scene/gltf/loader.h"

namespace {

using namespace amalgam;

struct Options {
  std::string scene, output = "markers.svg", dictionary = "DICT_6X6_250";
  std::vector<int> ids{40};
  double length = 0.05;
  bool letter = false;
};

// The markers that something in the scene stands on, the world marker first.
void take_from_scene(Options& options) {
  const scene::Scene scene = scene::load_scene(options.scene);
  options.dictionary = scene.world.dictionary;
  options.length = scene.world.marker_length;
  options.ids = {scene.world.marker};
  std::set<int> others;
  for (const scene::Instance& instance : scene.instances) {
    if (instance.marker) others.insert(*instance.marker);
  }
  others.erase(scene.world.marker);
  options.ids.insert(options.ids.end(), others.begin(), others.end());
}

void run(Options& options) {
  if (!options.scene.empty()) take_from_scene(options);
  const tools::MarkerSheet sheet =
      options.letter
          ? tools::lay_out_markers(options.dictionary, options.ids, options.length, 215.9, 279.4)
          : tools::lay_out_markers(options.dictionary, options.ids, options.length);
  common::write_whole_file(options.output, tools::to_svg(sheet));
  std::cout << options.output << ": " << sheet.markers.size()
            << " markers. Open it in a browser and print it at 100 % (no \"fit to page\"), then "
               "measure a black square: "
            << 1000.0 * options.length << " mm.\n";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Writes a page of markers to print, as SVG at true size.", "amalgam-marker");
  Options options;
  app.add_option("--id", options.ids, "markers' numbers")->capture_default_str();
  app.add_option("--length", options.length, "side of the black square, metres")
      ->capture_default_str();
  app.add_option("--dictionary", options.dictionary, "OpenCV's name, or a dictionary file (.yml)")
      ->capture_default_str();
  auto* scene = app.add_option("--scene", options.scene,
                               "glTF scene: all markers that something in it stands on");
  for (const char* other : {"--id", "--length", "--dictionary"})
    scene->excludes(app.get_option(other));
  app.add_flag("--letter", options.letter, "US letter instead of A4");
  app.add_option("--output", options.output, "SVG file to write")->capture_default_str();
  app.set_version_flag("--version", common::version_line("amalgam-marker"));
  return common::run_program("amalgam-marker", [&] {
    try {
      app.parse(argc, argv);
      run(options);
      return 0;
    } catch (const CLI::ParseError& error) {
      return app.exit(error);
    }
  });
}
