#include "bench/stage_sums.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace amalgam::bench {
namespace {

constexpr std::string_view kWhole = "total";

bool is_raster_stage(std::string_view name) {
  constexpr std::array<std::string_view, 6> kOthers{
      "trace", "decode", "encode", "light extraction", "place instances", "upload lights"};
  if (name == kWhole || name.starts_with("shadow maps")) return false;
  return std::find(kOthers.begin(), kOthers.end(), name) == kOthers.end();
}

template <typename Counts>
double sum_if(const core::StageTimes& stages, const Counts& counts) {
  double sum = 0.0;
  for (const core::StageTime& stage : stages) {
    if (counts(stage.stage)) sum += stage.milliseconds;
  }
  return sum;
}

}  // namespace

double stage_milliseconds(const core::StageTimes& stages, std::string_view name) {
  for (const core::StageTime& stage : stages) {
    if (stage.stage == name) return stage.milliseconds;
  }
  throw std::runtime_error("no stage '" + std::string(name) + "' in the frame");
}

double raster_milliseconds(const core::StageTimes& stages) {
  return sum_if(stages, is_raster_stage);
}

double sum_of_stages(const core::StageTimes& stages) {
  return sum_if(stages, [](const std::string& stage) { return stage != kWhole; });
}

}  // namespace amalgam::bench
