// amalgam-marker: a page of markers to print.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <string>

#include "client/tools/marker/scene_markers.h"
#include "client/tracking/board_description.h"
#include "common/build_info.h"
#include "common/parse_command_line.h"
#include "common/run_program.h"
#include "scene/gltf/loader.h"
#include "sheet/sheet_file.h"

namespace {

using namespace amalgam;

struct Options {
  std::string scene, output = "markers.pdf";
  sheet::SheetOptions sheet{.ids = {40}};
  std::string charuco;
  bool letter = false;
};

void run(Options& options) {
  if (!options.scene.empty()) {
    options.sheet = tools::markers_of(scene::load_scene(options.scene));
    options.sheet.title = std::filesystem::path(options.scene).filename().string();
  }
  if (options.letter) sheet::set_paper(options.sheet, "letter");
  if (!options.charuco.empty()) {
    options.sheet.title = "--charuco " + options.charuco + ", " + options.sheet.dictionary;
    const tracking::RegularBoard board = client::parse_charuco(options.charuco);
    sheet::write_sheet(options.output, sheet::lay_out_charuco(options.sheet, board));
    std::cout << options.output << ": for amalgam-client --charuco " << options.charuco
              << ", with --calibrate too. Print it at 100 %, or show it on a flat screen.\n";
    return;
  }
  sheet::write_sheet(options.output, sheet::lay_out_markers(options.sheet));
  std::cout << options.output << ": " << options.sheet.ids.size()
            << " markers. Print it at 100 % (no \"fit to page\"), then measure a black square: "
            << 1000.0 * options.sheet.length << " mm.\n";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Writes pages of markers to print at true size.", "amalgam-marker");
  Options options;
  app.add_option("--id", options.sheet.ids, "markers' numbers")->capture_default_str();
  app.add_option("--length", options.sheet.length, "side of the black square, metres")
      ->capture_default_str();
  app.add_option("--dictionary", options.sheet.dictionary,
                 "OpenCV's name, or a dictionary file (.yml)")
      ->capture_default_str();
  auto* scene = app.add_option("--scene", options.scene,
                               "glTF scene: all markers that something in it stands on");
  for (const char* other : {"--id", "--length", "--dictionary"})
    scene->excludes(app.get_option(other));
  auto* charuco = app.add_option("--charuco", options.charuco,
                                 "a ChArUco board instead, as 5x7:0.035:0.026: squares along both "
                                 "sides, square and marker in metres")
                      ->type_name("CxR:SQUARE:MARKER[:FIRST_ID]");
  for (const char* other : {"--id", "--length", "--scene"})
    charuco->excludes(app.get_option(other));
  app.add_flag("--letter", options.letter, "US letter instead of A4");
  app.add_option("--output", options.output, "file to write, .pdf or (one page) .svg")
      ->capture_default_str();
  app.set_version_flag("--version", common::version_line("amalgam-marker"));
  return common::run_program("amalgam-marker", [&] {
    if (!common::parse_command_line(app, argc, argv)) return 0;
    run(options);
    return 0;
  });
}
