#include "frame/costs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace amalgam::frame {
namespace {

constexpr std::array<std::string_view, 8> kPixelPasses{
    "mask", "reached tiles", "diffuse", "effect", "resolve", "real depth", "shadow bound", "merge"};

}  // namespace

FrameCost frame_cost(const FrameStatistics& statistics) {
  FrameCost cost;
  double total = 0.0;
  bool rasterised = false;
  for (const core::StageTime& time : statistics.stages) {
    const std::string_view stage = time.stage;
    if (stage == "total") total = time.milliseconds;
    if (stage == "trace" || stage == "refine") cost.trace += time.milliseconds;
    if (stage == "mask") rasterised = true;
    if (stage == "encode") cost.encode += time.milliseconds;
    if (std::find(kPixelPasses.begin(), kPixelPasses.end(), stage) != kPixelPasses.end()) {
      cost.raster += time.milliseconds;
    }
  }
  cost.other = std::max(0.0, total - cost.trace - cost.raster - cost.encode);
  if (!rasterised) {
    cost.specular = 1.0;
  } else if (statistics.pixels.total > 0) {
    cost.specular = static_cast<double>(statistics.pixels.specular) /
                    static_cast<double>(statistics.pixels.total);
  }
  return cost;
}

void RelativeCosts::learn(std::size_t from, std::size_t to, double measured) {
  if (from == to || !(measured > 0.0) || !std::isfinite(measured)) return;
  // Clamped, because more than the quality may have changed.
  const double correction = std::clamp(measured / ratio(to, from), 0.25, 4.0);
  const double distance = static_cast<double>(to) - static_cast<double>(from);
  for (std::size_t level = 0; level < costs_.size(); ++level) {
    const double way = (static_cast<double>(level) - static_cast<double>(from)) / distance;
    costs_[level] *= std::pow(correction, std::clamp(way, 0.0, 1.0));
  }
  // Less quality never costs more. The level just measured is kept, the others are adjusted.
  for (std::size_t level = to; level-- > 0;) {
    costs_[level] = std::max(costs_[level], costs_[level + 1]);
  }
  for (std::size_t level = to + 1; level < costs_.size(); ++level) {
    costs_[level] = std::min(costs_[level], costs_[level - 1]);
  }
}

}  // namespace amalgam::frame
