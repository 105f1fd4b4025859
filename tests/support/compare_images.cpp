#include "support/compare_images.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "codec/exr.h"

namespace amalgam::test_support {
namespace {

constexpr std::size_t kWorst = 10;

double channel_difference(float actual, float expected, double relative_floor) {
  const double difference = std::abs(static_cast<double>(actual) - static_cast<double>(expected));
  const double scale = relative_floor > 0.0
                           ? std::max(relative_floor, std::abs(static_cast<double>(expected)))
                           : 1.0;
  // Not std::isfinite(difference) alone: inf - inf and inf / inf must not slip through as NaN.
  if (!std::isfinite(actual) || !std::isfinite(expected)) {
    return std::numeric_limits<double>::infinity();
  }
  return difference / scale;
}

std::ostream& operator<<(std::ostream& out, const glm::vec3& color) {
  return out << '(' << color.r << ' ' << color.g << ' ' << color.b << ')';
}

}  // namespace

bool ImageComparison::within(const Tolerance& tolerance) const {
  return maximum <= tolerance.maximum && mean <= tolerance.mean;
}

std::string ImageComparison::describe() const {
  std::ostringstream text;
  text << std::setprecision(6) << "maximum " << maximum << ", mean " << mean << " over " << compared
       << " pixels; worst:\n";
  for (const PixelDifference& pixel : worst) {
    text << "  (" << pixel.x << ", " << pixel.y << "): " << pixel.difference << ", actual "
         << pixel.actual << ", expected " << pixel.expected << '\n';
  }
  return text.str();
}

ImageComparison compare_images(const common::ImageRgb32f& actual,
                               const common::ImageRgb32f& expected, const CompareOptions& options) {
  if (actual.size() != expected.size()) {
    throw std::invalid_argument("the images to compare differ in size");
  }
  ImageComparison result;
  double sum = 0.0;
  for (int y = 0; y < actual.height(); ++y) {
    for (int x = 0; x < actual.width(); ++x) {
      if (options.include != nullptr && options.include->at(x, y) == 0) continue;
      const glm::vec3 &a = actual.at(x, y), &e = expected.at(x, y);
      double difference = 0.0;
      for (glm::length_t c = 0; c < 3; ++c) {
        difference = std::max(difference, channel_difference(a[c], e[c], options.relative_floor));
      }
      ++result.compared;
      sum += difference;
      if (difference > 0.0) result.worst.push_back({x, y, difference, a, e});
    }
  }
  const std::size_t kept = std::min(kWorst, result.worst.size());
  std::partial_sort(result.worst.begin(), result.worst.begin() + static_cast<std::ptrdiff_t>(kept),
                    result.worst.end(), [](const PixelDifference& a, const PixelDifference& b) {
                      return a.difference > b.difference;
                    });
  result.worst.resize(kept);
  result.maximum = result.worst.empty() ? 0.0 : result.worst.front().difference;
  result.mean = result.compared == 0 ? 0.0 : sum / static_cast<double>(result.compared);
  return result;
}

std::string check_images(const std::string& name, const common::ImageRgb32f& actual,
                         const common::ImageRgb32f& expected, const Tolerance& tolerance,
                         const std::filesystem::path& folder, const CompareOptions& options) {
  const ImageComparison comparison = compare_images(actual, expected, options);
  if (comparison.within(tolerance)) return {};

  common::ImageRgb32f difference(actual.width(), actual.height());
  for (std::size_t i = 0; i < difference.pixels().size(); ++i) {
    difference.pixels()[i] = actual.pixels()[i] - expected.pixels()[i];
  }
  const std::filesystem::path target = folder / "failed-images";
  std::filesystem::create_directories(target);
  codec::write_exr(target / (name + "-actual.exr"), actual);
  codec::write_exr(target / (name + "-expected.exr"), expected);
  codec::write_exr(target / (name + "-difference.exr"), difference);

  std::ostringstream text;
  text << name << ": " << comparison.describe() << "  allowed: maximum " << tolerance.maximum
       << ", mean " << tolerance.mean << " (" << tolerance.reason << ")\n  images in "
       << target.string();
  return text.str();
}

common::ImageRgb32f as_floats(const common::ImageRgb8& image) {
  common::ImageRgb32f result(image.width(), image.height());
  std::transform(image.pixels().begin(), image.pixels().end(), result.pixels().begin(),
                 [](const common::Rgb8& pixel) { return glm::vec3(pixel); });
  return result;
}

}  // namespace amalgam::test_support
