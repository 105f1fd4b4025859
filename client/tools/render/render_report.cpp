#include "client/tools/render/render_report.h"

#include <algorithm>
#include <iomanip>
#include <map>
#include <nlohmann/json.hpp>

#include "client/tracking/poses_file.h"

namespace amalgam::tools {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

// Pixels' shares, summed by source.
nlohmann::ordered_json provenance_sums(const core::ProvenanceImage& provenance) {
  std::array<double, core::kLightSources> sums{};
  for (const core::Provenance& shares : provenance.pixels()) {
    for (std::size_t k = 0; k < core::kLightSources; ++k) sums[k] += static_cast<double>(shares[k]);
  }
  nlohmann::ordered_json json;
  for (std::size_t k = 0; k < core::kLightSources; ++k) json[core::kLightSourceNames[k]] = sums[k];
  return json;
}

nlohmann::ordered_json quality_json(const frame::FrameQuality& quality) {
  return {{"level", quality.level},
          {"lowest_level", quality.lowest_level},
          {"samples", quality.samples_per_pixel},
          {"adaptive", quality.adaptive},
          {"max_depth", quality.max_depth},
          {"importance_cutoff", quality.importance_cutoff},
          {"render_scale", quality.render_scale},
          {"jpeg_quality", quality.jpeg_quality},
          {"bound", to_string(quality.bound)}};
}

}  // namespace

void print_json(std::ostream& out, const std::vector<frame::FrameOutput>& frames,
                const std::vector<common::MarkerPose>& poses) {
  std::map<std::string, std::vector<double>> times;
  for (const frame::FrameOutput& frame : frames) {
    for (const core::StageTime& stage : frame.statistics.stages) {
      times[stage.stage].push_back(stage.milliseconds);
    }
  }
  const frame::FrameStatistics& last = frames.back().statistics;
  nlohmann::ordered_json json;
  json["stages_ms"] = nlohmann::ordered_json::object();
  for (const auto& [stage, values] : times) {
    json["stages_ms"][stage] = {{"min", *std::min_element(values.begin(), values.end())},
                                {"median", median(values)}};
  }
  json["rays"] = {{"primary", last.rays.primary},       {"reflection", last.rays.reflection},
                  {"refraction", last.rays.refraction}, {"shadow", last.rays.shadow},
                  {"lookup", last.rays.lookup},         {"reused", last.rays.reused}};
  json["passes"] = nlohmann::ordered_json::array();
  for (const frame::PassRecord& pass : last.passes) {
    json["passes"].push_back({{"name", pass.name}, {"ran", pass.ran}, {"reason", pass.reason}});
  }
  json["pixels"] = {{"virtual", last.pixels.virtual_pixels},
                    {"specular", last.pixels.specular},
                    {"refined", last.pixels.refined},
                    {"total", last.pixels.total}};
  json["provenance"] = provenance_sums(frames.back().provenance.value_or(core::ProvenanceImage{}));
  json["nonfinite"] = last.nonfinite;
  json["truncation_bound"] = {{"mean", last.truncation_bound.mean},
                              {"worst", last.truncation_bound.worst}};
  const glm::vec3& exposure = last.exposure;
  json["exposure"] = exposure.y;
  json["tone_map"] = last.tone_curve;
  json["white_balance"] = {exposure.x / exposure.y, 1.0f, exposure.z / exposure.y};
  if (last.quality) json["quality"] = quality_json(*last.quality);
  json["unchanged"] = frames.back().unchanged;
  json["frames"] = frames.size();
  json["poses"] = client::poses_json(poses);
  out << json.dump(2) << "\n";
}

void print_passes(std::ostream& out, const frame::FrameOutput& frame) {
  for (const frame::PassRecord& pass : frame.statistics.passes) {
    out << std::left << std::setw(29) << pass.name;
    if (pass.ran) {
      const auto& stages = frame.statistics.stages;
      const auto time = std::find_if(stages.begin(), stages.end(), [&](const core::StageTime& s) {
        return s.stage == pass.name;
      });
      out << "ran       " << std::fixed << std::setprecision(2)
          << (time != stages.end() ? time->milliseconds : 0.0) << " ms\n";
    } else {
      out << "left out  " << pass.reason << "\n";
    }
  }
}

}  // namespace amalgam::tools
