#include "frame/frame_cost.h"

#include <algorithm>
#include <array>
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

}  // namespace amalgam::frame
