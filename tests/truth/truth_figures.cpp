#include "truth/truth_figures.h"

#include <algorithm>
#include <cstdlib>

#include "bench/picture_error.h"

namespace amalgam::truth {
namespace {

// Above the noise of most pixels of camera image and truth, below what one sees.
constexpr int kChange = 4;

bool differ(const common::Rgb8& a, const common::Rgb8& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) > kChange;
}

}  // namespace

PixelSet object_pixels(const common::ImageRgb8& mask) {
  PixelSet set(mask.width(), mask.height());
  std::transform(mask.pixels().begin(), mask.pixels().end(), set.data(),
                 [](const common::Rgb8& share) { return share.r > 0 ? 1 : 0; });
  return set;
}

PixelSet changed_pixels(const common::ImageRgb8& mask, const common::ImageRgb8& camera,
                        const std::vector<const common::ImageRgb8*>& pictures) {
  PixelSet set(mask.width(), mask.height());
  for (std::size_t i = 0; i < set.pixels().size(); ++i) {
    if (mask.pixels()[i].r > 0) continue;
    const auto changes = [&](const common::ImageRgb8* picture) {
      return differ(picture->pixels()[i], camera.pixels()[i]);
    };
    set.pixels()[i] = std::any_of(pictures.begin(), pictures.end(), changes) ? 1 : 0;
  }
  return set;
}

Figures compare(const common::ImageRgb8& actual, const common::ImageRgb8& truth,
                const PixelSet& where) {
  const common::Image<float> similarity = bench::ssim_map(actual, truth);
  std::vector<double> errors;
  double sum = 0.0, ssim = 0.0;
  for (std::size_t i = 0; i < where.pixels().size(); ++i) {
    if (where.pixels()[i] == 0) continue;
    const glm::ivec3 step =
        glm::abs(glm::ivec3(actual.pixels()[i]) - glm::ivec3(truth.pixels()[i]));
    errors.push_back((step.r + step.g + step.b) / 3.0);
    sum += errors.back();
    ssim += static_cast<double>(similarity.pixels()[i]);
  }
  Figures figures;
  figures.pixels = errors.size();
  if (errors.empty()) return figures;
  const auto count = static_cast<double>(errors.size());
  figures.mean = sum / count;
  figures.ssim = ssim / count;
  const auto rank = static_cast<std::ptrdiff_t>(0.95 * (count - 1.0));
  std::nth_element(errors.begin(), errors.begin() + rank, errors.end());
  figures.percentile_95 = errors[static_cast<std::size_t>(rank)];
  return figures;
}

}  // namespace amalgam::truth
