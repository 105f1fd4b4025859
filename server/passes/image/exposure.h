// The tone map of a frame, the same for both images (numerics A4): its exposure is fixed, or
// metered and smoothed over time.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "graph/frame_graph.h"
#include "passes/image/decode.h"
#include "passes/image/paper_meter.h"

namespace amalgam::passes {

// What the exposure is metered on.
enum class ExposureCard : std::uint8_t {
  Paper,  // the markers' paper, or the real surfaces where that cannot be measured
  Grey,   // the real surfaces
};

// Throws std::invalid_argument naming the choices.
ExposureCard parse_exposure_card(std::string_view text);
const char* exposure_card_name(ExposureCard card);

struct MeterReading {
  std::optional<float> grey;       // by grey card
  std::optional<glm::vec3> paper;  // by paper, with white balance
};

// A view's exposure from frame to frame.
class ExposureMemory {
 public:
  // Returns the first reading unchanged, then moves a quarter of the way (in stops) towards each
  // later reading. Paper goes before grey card. Where only the grey card can be read, it is
  // corrected by what the last frame with both has taught: so a hand over the marker does not
  // change the light. Without a reading the last value stays; 1 before any.
  glm::vec3 update(const MeterReading& reading);

  // The camera's curve, by evidence_for_linear(). Reinhard before any evidence. Later evidence must
  // be strong to change it, so that noise cannot make the picture flicker. A change forgets the
  // exposure, which was of the other curve.
  scene::ToneCurve update_curve(const std::optional<float>& evidence_for_linear);

 private:
  std::optional<glm::vec3> last_;
  glm::vec3 paper_to_grey_{1.0f};
  std::optional<scene::ToneCurve> curve_;
};

struct ExposureInputs {
  std::optional<float> fixed;  // if set, nothing else is read
  // None: chosen by the markers' contrast; Reinhard if the exposure is fixed.
  std::optional<scene::ToneCurve> curve;
  ExposureCard card = ExposureCard::Paper;
  bool white_balance = true;  // otherwise all channels have green's exposure
  const common::CameraModel& camera;
  const common::CameraModel& ideal;
  SeenMarkers markers;
  graph::Handle<MeterGrid> grid;  // may be absent: no real surface in view
  graph::Handle<CameraImage> camera_image;
  ExposureMemory& memory;
};

graph::Handle<scene::ToneMap> add_exposure_pass(graph::FrameGraph& graph, const ExposureInputs& in);

}  // namespace amalgam::passes
