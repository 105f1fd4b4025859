#include "support/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace amalgam::test_support {
namespace {

struct Step {
  char character;
  double most;  // of the unit
};
constexpr std::array<Step, 6> kSteps = {
    {{'.', 0.01}, {':', 0.1}, {'-', 1.0}, {'+', 2.0}, {'*', 5.0}, {'#', 20.0}}};

char character_of(double difference, double unit) {
  if (difference == 0.0) return ' ';
  if (!std::isfinite(difference)) return '!';
  for (const Step& step : kSteps) {
    if (difference <= step.most * unit) return step.character;
  }
  return '@';
}

int divided_up(int length, int cell) {
  return (length + cell - 1) / cell;
}

// Characters are about twice as high as wide, and so are cells.
int cell_width(const common::Image<double>& image) {
  int width = 1;
  while (divided_up(image.width(), width) > kHeatMapWidth ||
         divided_up(image.height(), 2 * width) > kHeatMapHeight) {
    ++width;
  }
  return width;
}

double largest_in_cell(const common::Image<double>& image, int left, int top, int width) {
  double largest = 0.0;
  for (int y = top; y < std::min(top + 2 * width, image.height()); ++y) {
    for (int x = left; x < std::min(left + width, image.width()); ++x) {
      largest = std::max(largest, image.at(x, y));
    }
  }
  return largest;
}

struct Summary {
  double largest = 0.0;
  double largest_finite = 0.0;
  int x = 0, y = 0;  // of the first largest
  std::size_t over = 0;
};

Summary summarise(const common::Image<double>& image, double tolerance) {
  Summary summary;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const double difference = image.at(x, y);
      if (difference > tolerance) ++summary.over;
      if (std::isfinite(difference)) {
        summary.largest_finite = std::max(summary.largest_finite, difference);
      }
      if (difference > summary.largest) {
        summary.largest = difference;
        summary.x = x;
        summary.y = y;
      }
    }
  }
  return summary;
}

void put_legend(std::ostream& text, double unit) {
  text << "  ' ' equal";
  for (const Step& step : kSteps) {
    text << "  '" << step.character << "' to " << step.most * unit;
  }
  text << "  '@' more  '!' infinite\n";
}

}  // namespace

std::string heat_map(const common::Image<double>& differences, double tolerance) {
  const Summary summary = summarise(differences, tolerance);
  const double unit = tolerance > 0.0 ? tolerance : summary.largest_finite / 10.0;
  const int width = cell_width(differences);
  std::ostringstream text;
  for (int top = 0; top < differences.height(); top += 2 * width) {
    text << "  |";
    for (int left = 0; left < differences.width(); left += width) {
      text << character_of(largest_in_cell(differences, left, top, width), unit);
    }
    text << "|\n";
  }
  put_legend(text, unit);
  text << "  a character is " << width << " x " << 2 * width << " pixels; largest difference "
       << summary.largest << " at (" << summary.x << ", " << summary.y << "); " << summary.over
       << " of " << differences.pixels().size() << " pixels over the tolerance of " << tolerance
       << '\n';
  return text.str();
}

}  // namespace amalgam::test_support
