#include "passes/image/meter_grid.h"

#include <algorithm>
#include <cmath>

namespace amalgam::passes {

glm::dvec2 MeterGrid::ideal_pixel(int x, int y, const common::CameraModel& ideal) const {
  const int n = samples_per_side;
  const auto sample = [&](int i, int side) {
    return (std::min(i * step + step / 2, side * n - 1) + 0.5) / n - 0.5;
  };
  return {sample(x, ideal.width), sample(y, ideal.height)};
}

int meter_step(glm::ivec2 sample_size) {
  constexpr double kEntries = 5000.0;
  const double area = static_cast<double>(sample_size.x) * sample_size.y;
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(area / kEntries))));
}

}  // namespace amalgam::passes
