// Labels beside the points of a chart, without covering points or each other.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

namespace amalgam::report {

struct LabelledPoint {
  glm::dvec2 at{0.0};  // pixels, y upwards
  std::string text{};  // empty: only in the way of others
};

struct LabelPlace {
  glm::dvec2 at{0.0};  // pixels: the text's left end, at half its height
};

// A place for each point's text within [0, size], or nothing if there is no room for it. Earlier
// points choose first.
std::vector<std::optional<LabelPlace>> place_labels(const std::vector<LabelledPoint>& points,
                                                    const glm::dvec2& size);

}  // namespace amalgam::report
