#include "report/report_scene.h"

#include <cmath>
#include <memory>

#include "codec/jpeg.h"
#include "parity/parity_case.h"
#include "scene/gltf/loader.h"
#include "support/stiff_scenes.h"

namespace amalgam::report {

namespace {

using test_support::StiffScene;

// In a picture of half the width and height: what happens in them is the same everywhere. The
// camera's picture is made up, because their sizes have no desk.
bench::BenchCase load_stiff(const StiffScene& stiff, const std::filesystem::path& file, int width,
                            int height) {
  bench::BenchCase result;
  result.name = stiff.name;
  result.scene_path = file;
  if (!std::filesystem::exists(file)) {
    throw bench::MissingScene(file.string() + " is not there: generate_scenes.py makes it");
  }
  result.scene = scene::load_scene(file);
  result.camera = stiff.camera(width / 2, height / 2);
  result.input = {codec::encode_jpeg(parity::make_camera_image(width / 2, height / 2),
                                     bench::kCameraJpegQuality),
                  {stiff.pose}};
  return result;
}

bench::BenchCase move_stiff(const bench::BenchCase& bench_case, const glm::dvec2& offset) {
  bench::BenchCase moved = bench_case;
  moved.camera.cx += offset.x;
  moved.camera.cy += offset.y;
  return moved;
}

// In quick those of a metre that are stiff enough to show it. A reflectance of .999 is left out:
// the reference would have to follow 9,000 mirrors by recursion.
bool is_wanted(const StiffScene& stiff, bool quick) {
  if (stiff.kind == StiffScene::Kind::Corridor && stiff.parameter > 0.99) return false;
  if (!quick) return true;
  return stiff.name == "corridor-0.9-1m" || stiff.name == "stack-4-1m" ||
         stiff.name == "ball-2.42-1m" || stiff.name == "nested-1m" || stiff.name == "lens-1m";
}

}  // namespace

std::vector<ReportScene> report_scenes(const std::filesystem::path& folder, bool quick) {
  const auto desk = std::make_shared<const bench::BenchScenes>(folder);
  std::vector<ReportScene> scenes{
      {.name = "complex", .load = [desk](int w, int h) { return desk->complex(w, h); }},
      {.name = "glass bunny", .load = [desk](int w, int h) { return desk->glass_bunny(w, h); }},
      {.name = "mirror bunny", .load = [desk](int w, int h) { return desk->mirror_bunny(w, h); }},
      {.name = "glassware",
       .load = [desk](int w, int h) { return desk->on_desk("glassware", "glassware.gltf", w, h); }},
  };
  for (const StiffScene& stiff : test_support::stiff_scenes()) {
    if (!is_wanted(stiff, quick)) continue;
    const std::filesystem::path file =
        folder / "stiff" / std::filesystem::path(stiff.file).filename();
    ReportScene scene{.name = stiff.name,
                      .load = [stiff, file](int w, int h) { return load_stiff(stiff, file, w, h); },
                      .is_stiff = true,
                      .move = move_stiff};
    if (stiff.kind == StiffScene::Kind::Corridor) scene.bounce_reflectance = stiff.parameter;
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

glm::dvec2 sub_pixel_offset(int index) {
  // The solution of x^3 = x + 1.
  constexpr double kPlastic = 1.32471795724474602596;
  const auto place = [&](double step) {
    const double sum = 0.5 + index * step;
    return sum - std::floor(sum) - 0.5;
  };
  return {place(1.0 / kPlastic), place(1.0 / (kPlastic * kPlastic))};
}

bench::BenchCase moved_by(const bench::BenchCase& bench_case, const glm::dvec2& offset) {
  bench::BenchCase moved = bench_case;
  moved.camera.cx += offset.x;
  moved.camera.cy += offset.y;
  bench::set_pose(moved, bench_case.input.poses.front());
  return moved;
}

}  // namespace amalgam::report
