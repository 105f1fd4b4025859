#include "support/compare_images.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "support/heat_map.h"
#include "support/test_output.h"

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
  if (!std::isfinite(maximum)) return false;
  std::size_t over = 0;
  double sum = 0.0;
  for (const double difference : differences.pixels()) {
    if (difference > tolerance.maximum) {
      ++over;
    } else {
      sum += difference;
    }
  }
  const std::size_t kept = compared - over;
  return over <= tolerance.set_aside && sum <= tolerance.mean * static_cast<double>(kept);
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
  result.differences = common::Image<double>(actual.width(), actual.height());
  double sum = 0.0;
  for (int y = 0; y < actual.height(); ++y) {
    for (int x = 0; x < actual.width(); ++x) {
      if (options.include != nullptr && options.include->at(x, y) == 0) continue;
      const glm::vec3 &a = actual.at(x, y), &e = expected.at(x, y);
      double difference = 0.0;
      for (glm::length_t c = 0; c < 3; ++c) {
        difference = std::max(difference, channel_difference(a[c], e[c], options.relative_floor));
      }
      result.differences.at(x, y) = difference;
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

testing::AssertionResult images_agree(const std::string& name, const common::ImageRgb32f& actual,
                                      const common::ImageRgb32f& expected,
                                      const Tolerance& tolerance, const CompareOptions& options) {
  const ImageComparison comparison = compare_images(actual, expected, options);
  if (comparison.within(tolerance)) {
    // What is there is of an earlier run, unless this test has written it just now.
    if (!testing::Test::HasFailure()) remove_test_output(name);
    return testing::AssertionSuccess();
  }
  std::ostringstream text;
  text << name << ": " << comparison.describe() << "  allowed: maximum " << tolerance.maximum
       << ", mean " << tolerance.mean;
  if (tolerance.set_aside > 0) text << ", without " << tolerance.set_aside << " pixels";
  text << " (" << tolerance.reason << ")\n"
       << show_failure(name, actual, expected, comparison.differences, tolerance.maximum);
  return testing::AssertionFailure() << text.str();
}

testing::AssertionResult images_are_same(const std::string& name, const common::ImageRgb32f& actual,
                                         const common::ImageRgb32f& expected) {
  return images_agree(name, actual, expected, {0.0, 0.0, "the same picture to the bit"});
}

testing::AssertionResult images_are_same(const std::string& name, const common::ImageRgb8& actual,
                                         const common::ImageRgb8& expected) {
  return images_are_same(name, as_floats(actual), as_floats(expected));
}

std::string show_failure(const std::string& name, const common::ImageRgb32f& actual,
                         const common::ImageRgb32f& expected,
                         const common::Image<double>& differences, double tolerance) {
  // The difference's picture is white from where the heat map turns to '@'.
  return heat_map(differences, tolerance) +
         write_test_output(name, actual, expected, 20.0 * tolerance);
}

common::ImageRgb32f as_floats(const common::ImageRgb8& image) {
  common::ImageRgb32f result(image.width(), image.height());
  std::transform(image.pixels().begin(), image.pixels().end(), result.pixels().begin(),
                 [](const common::Rgb8& pixel) { return glm::vec3(pixel); });
  return result;
}

common::ImageRgb32f as_floats(const common::Image<glm::dvec3>& image) {
  common::ImageRgb32f result(image.width(), image.height());
  std::transform(image.pixels().begin(), image.pixels().end(), result.pixels().begin(),
                 [](const glm::dvec3& pixel) { return glm::vec3(pixel); });
  return result;
}

}  // namespace amalgam::test_support
