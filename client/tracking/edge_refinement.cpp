#include "client/tracking/edge_refinement.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

namespace amalgam::client {
namespace {

constexpr int kIterations = 3;     // the first guess is off by up to a pixel
constexpr double kMaxReach = 4.0;  // pixels to either side of an edge; further is no edge's blur
constexpr double kStep = 0.5;      // pixels between samples across an edge
constexpr double kMinContrast = 15.0;  // grey levels across an edge, of 255

struct Line {
  glm::dvec2 point, direction;
};

// One measured point of the edge: its distance along the side, and outward from it; pixels.
struct EdgePoint {
  double along = 0.0, outward = 0.0;
};

std::optional<double> grey_at(const cv::Mat& grey, const glm::dvec2& p) {
  if (!(p.x >= 0 && p.y >= 0 && p.x < grey.cols - 1 && p.y < grey.rows - 1)) return std::nullopt;
  const auto x = static_cast<int>(p.x), y = static_cast<int>(p.y);
  const double fx = p.x - x, fy = p.y - y;
  const auto* upper = grey.ptr<unsigned char>(y) + x;
  const auto* lower = grey.ptr<unsigned char>(y + 1) + x;
  return std::lerp(std::lerp(upper[0], upper[1], fx), std::lerp(lower[0], lower[1], fx), fy);
}

// The distance from the start at which brightness rises along the direction: the centre of mass of
// its increase.
std::optional<double> rise(const cv::Mat& grey, const glm::dvec2& start,
                           const glm::dvec2& direction, double reach) {
  double sum = 0.0, moment = 0.0;
  auto last = grey_at(grey, start - reach * direction);
  for (double at = -reach + kStep; at <= reach; at += kStep) {
    const auto value = grey_at(grey, start + at * direction);
    if (!last || !value) return std::nullopt;
    const double increase = std::max(*value - *last, 0.0);
    sum += increase;
    moment += increase * (at - kStep / 2);
    last = value;
  }
  if (sum < kMinContrast) return std::nullopt;
  return moment / sum;
}

// outward = offset + slope * along, by least squares.
std::optional<std::pair<double, double>> fit(const std::vector<EdgePoint>& points) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const auto& [x, y] : points) {
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double determinant = n * sxx - sx * sx;
  constexpr double kMinPoints = 4;
  if (n < kMinPoints || !(determinant > 1e-9)) return std::nullopt;
  const double slope = (n * sxy - sx * sy) / determinant;
  return std::pair((sy - slope * sx) / n, slope);
}

std::optional<Line> measure_edge(const cv::Mat& grey, const glm::dvec2& from, const glm::dvec2& to,
                                 double reach) {
  const double length = glm::distance(from, to);
  const glm::dvec2 direction = (to - from) / length;
  const glm::dvec2 outward(direction.y, -direction.x);  // corners go clockwise on the screen
  std::vector<EdgePoint> points;
  // Not near the ends, where the neighbouring edge's blur bends this one's.
  for (double along = reach; along <= length - reach; along += 1.0) {
    if (const auto at = rise(grey, from + along * direction, outward, reach)) {
      points.push_back({along, *at});
    }
  }
  auto line = fit(points);
  if (!line) return std::nullopt;
  // Dirt and printing errors are left out, by a second fit of what lies near the first one.
  constexpr double kMaxResidual = 0.5;  // pixels
  std::erase_if(points, [&](const EdgePoint& p) {
    return std::abs(p.outward - line->first - line->second * p.along) > kMaxResidual;
  });
  line = fit(points);
  if (!line) return std::nullopt;
  return Line{from + line->first * outward, direction + line->second * outward};
}

std::optional<glm::dvec2> intersection(const Line& a, const Line& b) {
  const double cross = a.direction.x * b.direction.y - a.direction.y * b.direction.x;
  if (std::abs(cross) < 1e-3) return std::nullopt;
  const glm::dvec2 between = b.point - a.point;
  const double t = (between.x * b.direction.y - between.y * b.direction.x) / cross;
  return a.point + t * a.direction;
}

}  // namespace

tracking::SquareCorners refine_corners(const cv::Mat& grey, int bits,
                                       const tracking::SquareCorners& corners) {
  tracking::SquareCorners refined = corners;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    std::array<std::optional<Line>, 4> edges;
    std::array<double, 4> bit{};  // pixels, along each side
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec2 &from = refined[i], &to = refined[(i + 1) % 4];
      // The bit across an edge is foreshortened as its neighbouring sides are.
      const double across = std::min(glm::distance(refined[(i + 3) % 4], from),
                                     glm::distance(to, refined[(i + 2) % 4]));
      bit[i] = across / (bits + 2);
      const double reach = std::clamp(0.6 * bit[i], 1.0, kMaxReach);
      edges[i] = measure_edge(grey, from, to, reach);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t before = (i + 3) % 4;
      if (!edges[before] || !edges[i]) continue;
      const auto corner = intersection(*edges[before], *edges[i]);
      const double furthest = std::max(1.5, std::max(bit[i], bit[before]) / 2);
      if (corner && glm::distance(*corner, corners[i]) <= furthest) refined[i] = *corner;
    }
  }
  return refined;
}

}  // namespace amalgam::client
