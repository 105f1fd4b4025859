// A scene of the report, and the views of it that its runs look through.
#pragma once

#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_case.h"

namespace amalgam::report {

// The case with its principal point moved, and the picture of the desk that this camera takes.
bench::BenchCase moved_by(const bench::BenchCase& bench_case, const glm::dvec2& offset);

struct ReportScene {
  std::string name;  // "glass bunny"
  // Throws bench::MissingScene with how to get it.
  std::function<bench::BenchCase(int width, int height)> load;
  // For scenes whose light comes back from mirrors alone: what each of them reflects. The error
  // after D bounces then falls as r^D (numerics B7).
  std::optional<double> bounce_reflectance{};
  // A stiff scene: only depth and cut-off are turned, and no tracker's noise is measured.
  bool is_stiff = false;
  // The case with its principal point moved, and the picture that this camera takes.
  std::function<bench::BenchCase(const bench::BenchCase&, const glm::dvec2& offset)> move =
      moved_by;
};

// All scenes, whether they are there or not. This is the place to add some.
// quick: one of each kind of stiff scene.
std::vector<ReportScene> report_scenes(const std::filesystem::path& folder, bool quick);

// Where the camera's principal point moves to in run 0, 1, ...: within +-0.5 pixels. The first does
// not move it; the others fill the square evenly (the R2 sequence, Roberts 2018).
glm::dvec2 sub_pixel_offset(int index);

}  // namespace amalgam::report
