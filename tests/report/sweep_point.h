// One setting of the renderer in a sweep, and what it is compared with.
#pragma once

#include <optional>
#include <string>

#include "frame/renderer_settings.h"

namespace amalgam::report {

// A picture by the double-precision renderer.
struct ReferenceSpec {
  int samples_per_side = 16;
  int max_depth = 64;
  // Not 0: inside glass each ray makes two, so that without a cut-off there are 2^depth.
  double importance_cutoff = 1e-4;
  bool exact_fresnel = true;
  scene::EnvLightOptions env_lights;

  bool operator==(const ReferenceSpec&) const = default;
};

// "16x16 samples, depth 64, cut-off 0.0001, exact Fresnel, lights sectors".
std::string to_string(const ReferenceSpec& spec);

struct SweepPoint {
  std::string sweep;   // the knob that is turned: "samples"
  std::string label;   // its value: "9"
  double value = 0.0;  // likewise as a number, for fits; NaN if it is none
  frame::RendererSettings settings;
  int jpeg_quality = 0;  // that the client asks for; 0: the composite is a patch of its JPEG

  ReferenceSpec reference;  // the best picture: how far off is this setting?
  // The point's own settings with the knob at its limit: what does this knob alone cost? For sweeps
  // with an expected law.
  std::optional<ReferenceSpec> limit;
};

}  // namespace amalgam::report
