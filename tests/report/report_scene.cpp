#include "report/report_scene.h"

#include <cmath>
#include <memory>

namespace amalgam::report {

std::vector<ReportScene> report_scenes(const std::filesystem::path& folder) {
  const auto scenes = std::make_shared<const bench::BenchScenes>(folder);
  return {
      {"complex", [scenes](int w, int h) { return scenes->complex(w, h); }},
      {"glass bunny", [scenes](int w, int h) { return scenes->glass_bunny(w, h); }},
      {"mirror bunny", [scenes](int w, int h) { return scenes->mirror_bunny(w, h); }},
      {"glassware",
       [scenes](int w, int h) { return scenes->on_desk("glassware", "glassware.gltf", w, h); }},
  };
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
