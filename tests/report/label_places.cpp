#include "report/label_places.h"

#include <algorithm>

namespace amalgam::report {
namespace {

// Pixels. Letters differ in width; this is more than most have.
constexpr double kLetterWidth = 6.9, kHeight = 12.0;
constexpr double kPointRadius = 4.0;

struct Box {
  glm::dvec2 low, high;
  bool overlaps(const Box& other) const {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y &&
           other.low.y < high.y;
  }
};

Box box_around(const glm::dvec2& point) {
  return {point - kPointRadius, point + kPointRadius};
}

Box box_of_text(const glm::dvec2& left, double width) {
  return {left - glm::dvec2(0.0, 0.5 * kHeight), left + glm::dvec2(width, 0.5 * kHeight)};
}

}  // namespace

std::vector<std::optional<LabelPlace>> place_labels(const std::vector<LabelledPoint>& points,
                                                    const glm::dvec2& size) {
  std::vector<Box> taken;
  for (const LabelledPoint& point : points) taken.push_back(box_around(point.at));
  std::vector<std::optional<LabelPlace>> places;
  for (const LabelledPoint& point : points) {
    places.emplace_back();
    if (point.text.empty()) continue;
    const double width = kLetterWidth * static_cast<double>(point.text.size());
    const double beside = kPointRadius + 2.0, above = 0.5 * kHeight + kPointRadius;
    for (const glm::dvec2& step :
         {glm::dvec2(beside, above), glm::dvec2(-beside - width, -above),
          glm::dvec2(beside, -above), glm::dvec2(-beside - width, above), glm::dvec2(beside, 0.0),
          glm::dvec2(-beside - width, 0.0), glm::dvec2(-0.5 * width, above + 1.0),
          glm::dvec2(-0.5 * width, -above - 1.0)}) {
      const Box box = box_of_text(point.at + step, width);
      const bool inside =
          box.low.x >= 0.0 && box.low.y >= 0.0 && box.high.x <= size.x && box.high.y <= size.y;
      if (!inside || std::any_of(taken.begin(), taken.end(),
                                 [&](const Box& other) { return box.overlaps(other); })) {
        continue;
      }
      taken.push_back(box);
      places.back() = LabelPlace{point.at + step};
      break;
    }
  }
  return places;
}

}  // namespace amalgam::report
