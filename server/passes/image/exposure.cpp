#include "passes/image/exposure.h"

#include <cmath>
#include <glm/exponential.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "passes/image/exposure_meter.h"

namespace amalgam::passes {
namespace {

std::optional<glm::vec3> exposure_of(const MeterReading& reading, const glm::vec3& paper_to_grey) {
  if (reading.paper) return reading.paper;
  if (reading.grey) return *reading.grey * paper_to_grey;
  return std::nullopt;
}

scene::ToneMap meter(const ExposureInputs& in, const MeterGrid* grid,
                     const common::ImageRgb8& image) {
  std::vector<PaperSample> paper;
  const bool wants_paper = !in.curve || in.card == ExposureCard::Paper;
  if (grid != nullptr && wants_paper)
    paper = sample_paper(*grid, in.markers, in.ideal, in.camera, image);
  const scene::ToneCurve curve =
      in.curve ? *in.curve : in.memory.update_curve(evidence_for_linear(paper));
  MeterReading reading;
  if (grid != nullptr) reading.grey = meter_exposure(*grid, in.ideal, in.camera, image, curve);
  if (in.card == ExposureCard::Paper) reading.paper = meter_paper(paper, curve);
  if (reading.paper && !in.white_balance) reading.paper = glm::vec3(reading.paper->y);
  return {in.memory.update(reading), curve};
}

}  // namespace

ExposureCard parse_exposure_card(std::string_view text) {
  for (const ExposureCard card : {ExposureCard::Paper, ExposureCard::Grey}) {
    if (text == exposure_card_name(card)) return card;
  }
  throw std::invalid_argument("meter '" + std::string(text) + "' is neither paper nor grey");
}

const char* exposure_card_name(ExposureCard card) {
  return card == ExposureCard::Paper ? "paper" : "grey";
}

glm::vec3 ExposureMemory::update(const MeterReading& reading) {
  constexpr float kShare = 0.25f;
  if (reading.paper && reading.grey) paper_to_grey_ = *reading.paper / *reading.grey;
  const std::optional<glm::vec3> now = exposure_of(reading, paper_to_grey_);
  if (!now) return last_.value_or(glm::vec3(1.0f));
  last_ = last_ ? *last_ * glm::pow(*now / *last_, glm::vec3(kShare)) : *now;
  return *last_;
}

scene::ToneCurve ExposureMemory::update_curve(const std::optional<float>& evidence_for_linear) {
  constexpr float kStrong = 0.5f;
  if (!evidence_for_linear) return curve_.value_or(scene::ToneCurve::Reinhard);
  const scene::ToneCurve likelier =
      *evidence_for_linear > 0.0f ? scene::ToneCurve::Linear : scene::ToneCurve::Reinhard;
  if (curve_ && (likelier == *curve_ || std::abs(*evidence_for_linear) < kStrong)) return *curve_;
  curve_ = likelier;
  last_.reset();
  return *curve_;
}

graph::Handle<scene::ToneMap> add_exposure_pass(graph::FrameGraph& graph,
                                                const ExposureInputs& in) {
  if (in.fixed) {
    graph.note_left_out("exposure", "the exposure is fixed");
    return graph.import(
        "tone map", scene::tone_map_of(*in.fixed, in.curve.value_or(scene::ToneCurve::Reinhard)));
  }
  graph::Builder builder = graph.add_pass("exposure");
  builder.needs(in.camera_image);
  builder.uses(in.grid);
  const auto out = builder.writes<scene::ToneMap>("tone map");
  builder.runs([in, out](const graph::Access& access) {
    access.set(out, meter(in, access.find(in.grid), access.get(in.camera_image).pixels));
  });
  return out;
}

}  // namespace amalgam::passes
