#include "client/synthetic/desk_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

namespace amalgam::client {
namespace {

using Color = glm::vec3;
using Point = glm::dvec2;
// Nothing outside the thing.
using Layer = std::optional<Color>;

constexpr double kDegree = 0.017453292519943295;

// A fixed pseudo-random number in 0..1 for a cell of a grid.
double hash(std::int64_t x, std::int64_t y) {
  auto h = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ull ^
           static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4Full;
  h = (h ^ (h >> 29)) * 0xBF58476D1CE4E5B9ull;
  return static_cast<double>((h ^ (h >> 32)) >> 11) * 0x1p-53;
}

// Value noise, 0..1, about one bump a unit.
double noise(const Point& p) {
  const Point cell = glm::floor(p);
  const Point f = p - cell;
  const Point s = f * f * (3.0 - 2.0 * f);
  const auto x = static_cast<std::int64_t>(cell.x), y = static_cast<std::int64_t>(cell.y);
  return glm::mix(glm::mix(hash(x, y), hash(x + 1, y), s.x),
                  glm::mix(hash(x, y + 1), hash(x + 1, y + 1), s.x), s.y);
}

// The point in the frame of a thing that lies at a place, turned counter-clockwise.
Point in_frame_of(const Point& place, double degrees, const Point& p) {
  const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
  const Point d = p - place;
  return {c * d.x + s * d.y, -s * d.x + c * d.y};
}

bool inside(const Point& p, double half_width, double half_height) {
  return std::abs(p.x) <= half_width && std::abs(p.y) <= half_height;
}

bool odd(double value) {
  return (static_cast<std::int64_t>(std::floor(value)) & 1) != 0;
}

// Bleached wood, about as bright and neutral as the scenes' model of the table. Differential
// rendering darkens by the model's color, so a dark or strongly colored desk would get colored
// shadows.
Color wood(const Point& p) {
  constexpr double kPlank = 0.115;  // metres wide, running along x
  const double row = std::floor(p.y / kPlank);
  const auto plank = static_cast<std::int64_t>(row);
  const double across = p.y - row * kPlank;
  if (across < 0.0018) return {128, 117, 104};  // the gap between planks
  const double shift = 10.0 * hash(plank, 1);
  const double waves = noise({p.x * 4.0 + shift, p.y * 30.0});
  const double grain = noise({p.x * 9.0 + shift, p.y * 260.0 + 6.0 * waves});
  const double rings = 0.5 + 0.5 * std::sin(across * 380.0 + 14.0 * waves + shift);
  const double tone = 0.80 + 0.22 * hash(plank, 2) - 0.13 * grain - 0.10 * rings;
  return Color(glm::dvec3(250, 240, 224) * tone);
}

Layer sheet(const Point& p) {
  if (std::abs(p.x) > kSheetHalfWidth || p.y < kSheetBottom || p.y > kSheetTop) return {};
  const bool printed = p.y < -0.042 && p.y > -0.074 && std::abs(p.x) < 0.040;
  const double line = (p.y + 0.042) / -0.008;  // lines of text, 8 mm apart
  if (printed && line - std::floor(line) < 0.42) {
    const auto word = static_cast<std::int64_t>(std::floor((p.x + 0.1) / 0.0022));
    if (hash(word, static_cast<std::int64_t>(line)) > 0.28) return Color(70, 74, 92);
  }
  return Color(236, 236, 232);
}

Layer checked_cloth(const Point& p) {
  const Point q = in_frame_of({-0.19, 0.27}, 9.0, p);
  if (!inside(q, 0.175, 0.15)) return {};
  const double check = 0.025;
  const int red = static_cast<int>(odd(q.x / check)) + static_cast<int>(odd(q.y / check));
  const double weave = 0.94 + 0.06 * noise(q * 900.0);
  constexpr std::array<glm::dvec3, 3> kTones{{{240, 234, 226}, {222, 112, 104}, {186, 28, 34}}};
  return Color(kTones[static_cast<std::size_t>(red)] * weave);
}

Layer notebook(const Point& p) {
  const Point q = in_frame_of({0.19, 0.24}, -14.0, p);
  if (!inside(q, 0.085, 0.12)) return {};
  if (q.x < -0.068) return Color(20, 28, 70);  // the spine
  if (std::abs(q.y - 0.065) < 0.026 && std::abs(q.x - 0.01) < 0.05) return Color(242, 236, 210);
  if (std::abs(q.y + 0.055) < 0.006 || std::abs(q.y + 0.08) < 0.006) return Color(246, 200, 36);
  return Color(32, 76, 176);
}

Layer color_card(const Point& p) {
  const Point q = in_frame_of({0.155, -0.005}, 8.0, p);
  if (!inside(q, 0.044, 0.058)) return {};
  constexpr double kPitch = 0.027;
  const Point cell = (q + Point(1.5 * kPitch, 2.0 * kPitch)) / kPitch;
  const Point within = cell - glm::floor(cell) - 0.5;
  const bool on_swatch = cell.x >= 0 && cell.x < 3 && cell.y >= 0 && cell.y < 4 &&
                         std::max(std::abs(within.x), std::abs(within.y)) < 0.42;
  if (!on_swatch) return Color(28, 28, 30);
  constexpr std::array<Color, 12> kSwatches{{{222, 60, 48},
                                             {64, 160, 70},
                                             {44, 70, 160},
                                             {240, 196, 30},
                                             {190, 84, 150},
                                             {20, 140, 166},
                                             {240, 130, 40},
                                             {96, 60, 110},
                                             {166, 190, 60},
                                             {244, 244, 240},
                                             {150, 150, 150},
                                             {84, 84, 86}}};
  const auto index = static_cast<std::size_t>(cell.y) * 3 + static_cast<std::size_t>(cell.x);
  return kSwatches[index];
}

Layer coaster(const Point& p) {
  const double r = glm::length(p - Point(-0.145, -0.03));
  if (r > 0.048) return {};
  if (r > 0.043) return Color(16, 84, 66);
  return odd(r / 0.009) ? Color(38, 150, 106) : Color(226, 232, 190);
}

Layer ruler(const Point& p) {
  const Point q = in_frame_of({0.03, -0.125}, -4.0, p);
  if (!inside(q, 0.155, 0.015)) return {};
  const double millimetre = (q.x + 0.15) * 1000.0;
  const auto tick = static_cast<std::int64_t>(std::floor(millimetre));
  const bool on_scale = millimetre >= 0 && millimetre < 300;
  const double tick_length = tick % 10 == 0 ? 0.011 : (tick % 5 == 0 ? 0.008 : 0.005);
  const bool inked = tick % 10 == 0 || millimetre - std::floor(millimetre) < 0.4;
  if (on_scale && inked && 0.015 - q.y < tick_length) return Color(40, 30, 20);
  return Color(244, 206, 74);
}

Layer pencil(const Point& p) {
  const Point q = in_frame_of({-0.16, 0.085}, 28.0, p);
  if (!inside(q, 0.085, 0.0038)) return {};
  const double to_tip = 0.085 - q.x;
  if (to_tip < 0.018) {
    if (std::abs(q.y) > 0.0038 * to_tip / 0.018) return {};
    return to_tip < 0.005 ? Color(30, 30, 34) : Color(228, 190, 140);
  }
  if (q.x < -0.073) return Color(226, 120, 130);  // the rubber
  return std::abs(q.y) < 0.0014 ? Color(250, 150, 60) : Color(224, 104, 24);
}

}  // namespace

glm::vec3 desk_picture(const glm::dvec2& point) {
  for (const auto& layer : {sheet, pencil, ruler, coaster, color_card, notebook, checked_cloth}) {
    if (const Layer color = layer(point)) return *color;
  }
  return wood(point);
}

}  // namespace amalgam::client
