#include "passes/image/paper_meter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <vector>

#include "passes/image/exposure_meter.h"

namespace amalgam::passes {
namespace {

// Half the side of the square that is measured, in sides of the marker: the black square and the
// part of the white margin that every detector needs.
constexpr double kHalf = 0.56;
constexpr int kPointsPerSide = 32;
constexpr double kLeastPixels = 12.0;  // a marker's side: smaller ones are blurred to grey
constexpr float kLeastContrast = 2.5f;

using Colors = std::vector<glm::vec3>;

template <typename Value>
glm::vec3 median_channels(const std::vector<Value>& values) {
  glm::vec3 median;
  std::vector<float> channel(values.size());
  for (int i = 0; i < 3; ++i) {
    std::transform(values.begin(), values.end(), channel.begin(),
                   [i](const Value& value) { return value[i]; });
    const auto middle = channel.begin() + static_cast<std::ptrdiff_t>(channel.size() / 2);
    std::nth_element(channel.begin(), middle, channel.end());
    median[i] = *middle;
  }
  return median;
}

// Whether the marker is whole in the image and large enough.
bool is_measurable(const glm::dmat4& camera_from_marker, double length,
                   const common::CameraModel& camera) {
  static const std::array<glm::dvec2, 4> kCorners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  glm::dvec2 low(1e9), high(-1e9);
  for (const glm::dvec2& corner : kCorners) {
    const auto at = common::project(
        camera, glm::dvec3(camera_from_marker * glm::dvec4(kHalf * length * corner, 0.0, 1.0)));
    if (!at) return false;
    low = glm::min(low, glm::dvec2(*at));
    high = glm::max(high, glm::dvec2(*at));
  }
  return low.x >= 0.0 && low.y >= 0.0 && high.x <= camera.width - 1 &&
         high.y <= camera.height - 1 && std::min(high.x - low.x, high.y - low.y) >= kLeastPixels;
}

// Display-linear, by rising luminance.
Colors marker_colors(const glm::dmat4& camera_from_marker, double length,
                     const common::CameraModel& camera, const common::ImageRgb8& image) {
  Colors colors;
  for (int j = 0; j < kPointsPerSide; ++j) {
    for (int i = 0; i < kPointsPerSide; ++i) {
      const glm::dvec2 uv = (glm::dvec2(i, j) + 0.5) * (2.0 / kPointsPerSide) - 1.0;
      const auto at = common::project(
          camera, glm::dvec3(camera_from_marker * glm::dvec4(kHalf * length * uv, 0.0, 1.0)));
      if (!at) continue;
      const int x = std::clamp(static_cast<int>(std::lround(at->x)), 0, image.width() - 1);
      const int y = std::clamp(static_cast<int>(std::lround(at->y)), 0, image.height() - 1);
      colors.push_back(scene::srgb_decode(image.at(x, y)));
    }
  }
  std::sort(colors.begin(), colors.end(),
            [](const glm::vec3& a, const glm::vec3& b) { return luminance(a) < luminance(b); });
  return colors;
}

// The mean of the colors between two shares of them. The very darkest and brightest are noise and
// gloss.
glm::vec3 mean_between(const Colors& colors, double from, double to) {
  const auto count = static_cast<double>(colors.size());
  const auto first = static_cast<std::size_t>(from * count);
  const auto end = std::max(first + 1, static_cast<std::size_t>(to * count));
  glm::vec3 sum(0.0f);
  for (std::size_t i = first; i < end; ++i) sum += colors[i];
  return sum / static_cast<float>(end - first);
}

// The median of MeterGrid::white on the marker.
std::optional<glm::vec3> white_on(const MeterGrid& grid, const glm::dmat4& camera_from_marker,
                                  double length, const common::CameraModel& ideal) {
  const glm::dvec3 centre(camera_from_marker[3]), x(camera_from_marker[0]),
      y(camera_from_marker[1]), normal(camera_from_marker[2]);
  std::vector<glm::vec4> white;
  for (int j = 0; j < grid.white.height(); ++j) {
    for (int i = 0; i < grid.white.width(); ++i) {
      const glm::vec4& entry = grid.white.at(i, j);
      const bool lit = entry.x > 0.0f && entry.y > 0.0f && entry.z > 0.0f;
      if (entry.w < 0.5f || !lit || !std::isfinite(entry.x + entry.y + entry.z)) continue;
      const auto direction = common::pixel_direction(ideal, grid.ideal_pixel(i, j, ideal));
      if (!direction) continue;
      const glm::dvec3& ray = *direction;
      const double t = glm::dot(centre, normal) / glm::dot(ray, normal);
      if (!(t > 0.0) || !std::isfinite(t)) continue;
      const glm::dvec3 offset = t * ray - centre;
      if (std::max(std::abs(glm::dot(offset, x)), std::abs(glm::dot(offset, y))) <= 0.5 * length)
        white.push_back(entry);
    }
  }
  if (white.empty()) return std::nullopt;
  return median_channels(white);
}

bool is_black_on_white(const PaperSample& sample) {
  return luminance(sample.paper) >= kLeastContrast * luminance(sample.ink) &&
         luminance(sample.paper) >= darkest_metered();
}

bool is_clipped(const glm::vec3& display) {
  return std::max({display.x, display.y, display.z}) > brightest_metered();
}

glm::vec3 exposure_by(const PaperSample& sample, scene::ToneCurve curve) {
  const scene::ToneMap response = scene::tone_map_of(1.0f, curve);
  const glm::vec3 by_paper =
      scene::inverse_tone_map(sample.paper, response) / (kPaper * sample.white);
  if (!is_clipped(sample.paper)) return by_paper;
  // Clipped paper is at least that bright.
  const float white = luminance(sample.white);
  float exposure = luminance(by_paper * sample.white) / white;
  if (luminance(sample.ink) >= darkest_metered()) {
    const float by_ink = luminance(scene::inverse_tone_map(sample.ink, response)) / (kInk * white);
    exposure = std::max(exposure, by_ink);
  }
  return glm::vec3(exposure);
}

// Evidence for Linear by clipped paper alone. Reinhard's curve never reaches white: by it such
// paper would be a hundred times as bright as a desk is, and virtual objects with it.
constexpr float kClipping = 1.0f;

// By how much the radiance of ink and paper differs from what their reflectance says: |ln|.
float contrast_error(const PaperSample& sample, scene::ToneCurve curve) {
  const scene::ToneMap response = scene::tone_map_of(1.0f, curve);
  const float ink = luminance(scene::inverse_tone_map(sample.ink, response));
  const float paper = luminance(scene::inverse_tone_map(sample.paper, response));
  return std::abs(std::log(ink / paper / (kInk / kPaper)));
}

}  // namespace

std::vector<PaperSample> sample_paper(const MeterGrid& grid, const SeenMarkers& markers,
                                      const common::CameraModel& ideal,
                                      const common::CameraModel& camera,
                                      const common::ImageRgb8& image) {
  std::vector<PaperSample> samples;
  for (const common::MarkerPose& pose : markers.poses) {
    if (!common::is_usable(pose)) continue;
    const glm::dmat4 camera_from_marker = common::to_matrix(pose);
    if (!is_measurable(camera_from_marker, markers.length, camera)) continue;
    const auto white = white_on(grid, camera_from_marker, markers.length, ideal);
    if (!white) continue;
    const Colors colors = marker_colors(camera_from_marker, markers.length, camera, image);
    const PaperSample sample{mean_between(colors, 0.02, 0.10), mean_between(colors, 0.88, 0.98),
                             *white};
    if (is_black_on_white(sample)) samples.push_back(sample);
  }
  return samples;
}

std::optional<glm::vec3> meter_paper(std::span<const PaperSample> samples, scene::ToneCurve curve) {
  if (samples.empty()) return std::nullopt;
  std::vector<glm::vec3> readings;
  for (const PaperSample& sample : samples) readings.push_back(exposure_by(sample, curve));
  const glm::vec3 exposure = median_channels(readings);
  const float green = std::clamp(exposure.y, 1e-6f, 1e6f);
  return glm::clamp(exposure, green / kMostBalance, green * kMostBalance);
}

std::optional<float> evidence_for_linear(std::span<const PaperSample> samples) {
  std::vector<float> evidence;
  for (const PaperSample& sample : samples) {
    if (luminance(sample.ink) >= darkest_metered()) {
      evidence.push_back(contrast_error(sample, scene::ToneCurve::Reinhard) -
                         contrast_error(sample, scene::ToneCurve::Linear));
    } else if (is_clipped(sample.paper)) {
      evidence.push_back(kClipping);
    }
  }
  if (evidence.empty()) return std::nullopt;
  const auto middle = evidence.begin() + static_cast<std::ptrdiff_t>(evidence.size() / 2);
  std::nth_element(evidence.begin(), middle, evidence.end());
  return *middle;
}

}  // namespace amalgam::passes
