#include "report/laws.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "report/fit.h"

namespace amalgam::report {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kLeastPoints = 3;

struct Curve {
  std::vector<double> knob, error;
};

// What is expected of a sweep's slope; nothing if it has no law in this scene.
std::optional<Law> expected_law(const std::string& scene, const std::string& sweep,
                                const std::map<std::string, double>& reflectances) {
  const auto law = [&](const char* quantity, const char* expected, double low, double high) {
    return Law{.scene = scene,
               .sweep = sweep,
               .quantity = quantity,
               .expected = expected,
               .low = low,
               .high = high};
  };
  if (sweep == "samples") {
    return law("power of the number of samples", "-0.75 to -0.5", -0.75, -0.5);
  }
  // Between facing mirrors the error is in proportion to the cut-off. Elsewhere rays branch, with
  // few different weights, and no such law is known.
  if (sweep == "cut-off" && reflectances.contains(scene)) {
    return law("power of the cut-off", "1", 1.0, 1.0);
  }
  if (sweep == "lights") {
    return law("power of the number of lights", "below 0", -kInfinity, 0.0);
  }
  if (sweep == "depth" && reflectances.contains(scene)) {
    const double slope = std::log(reflectances.at(scene));
    char expected[32];
    std::snprintf(expected, sizeof expected, "%.3g", slope);
    return law("ln of the error, a bounce", expected, slope, slope);
  }
  return std::nullopt;
}

bool within(const Law& law) {
  return law.slope >= law.low - kSlopeTolerance * std::abs(law.low) &&
         law.slope <= law.high + kSlopeTolerance * std::abs(law.high);
}

}  // namespace

std::vector<Law> find_laws(const std::vector<PointSummary>& points,
                           const std::map<std::string, double>& reflectances) {
  std::vector<std::pair<std::string, std::string>> order;  // scene, sweep
  std::map<std::pair<std::string, std::string>, Curve> curves;
  for (const PointSummary& point : points) {
    if (!(point.limit_mae > kNoEffect) || std::isnan(point.value)) continue;
    const std::pair key(point.scene, point.sweep);
    if (!curves.contains(key)) order.push_back(key);
    curves[key].knob.push_back(point.value);
    curves[key].error.push_back(point.limit_mae);
  }
  std::vector<Law> laws;
  for (const auto& key : order) {
    auto law = expected_law(key.first, key.second, reflectances);
    const Curve& curve = curves[key];
    if (!law || curve.knob.size() < kLeastPoints) continue;
    const auto fit = law->sweep == "depth" ? fit_exponential(curve.knob, curve.error)
                                           : fit_power(curve.knob, curve.error);
    if (!fit) continue;
    law->slope = fit->slope;
    law->pass = within(*law);
    laws.push_back(*law);
  }
  return laws;
}

void set_slopes(std::vector<PointSummary>& points, const std::vector<Law>& laws) {
  for (PointSummary& point : points) {
    for (const Law& law : laws) {
      if (law.scene == point.scene && law.sweep == point.sweep) point.slope = law.slope;
    }
  }
}

}  // namespace amalgam::report
