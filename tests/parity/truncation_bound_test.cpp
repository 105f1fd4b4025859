// The bound that each frame states, held against the error that it is a bound of: scenes that come
// with Amalgam, rendered by both methods at many depths and cut-offs, against rays that almost
// never end.
#include <gtest/gtest.h>

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "parity/composite_error.h"
#include "parity/rendering.h"

namespace amalgam::parity {
namespace {

// Lamps make the bound wide: any cut ray might have met one. Without them its width shows whether
// it says anything.
void dim_lamps(scene::Scene& scene) {
  for (glm::vec3& texel : scene.environment->radiance.pixels())
    texel = glm::min(texel, glm::vec3(2.0f));
}

struct Cut {
  int depth;
  float importance;
};

Rendering render_cut(ParityCase parity_case, frame::RendererMode mode, const Cut& cut) {
  frame::RendererSettings settings;
  settings.mode = mode;
  parity_case.max_depth = cut.depth;
  parity_case.importance_cutoff = cut.importance;
  return render(parity_case, settings);
}

void hold_bound(const ParityCase& parity_case, frame::RendererMode mode, const char* light) {
  const Rendering endless = render_cut(parity_case, mode, {40, 1e-3f});
  const frame::TruncationBound& rest = endless.statistics.truncation_bound;
  for (const Cut& cut : {Cut{0, 0.0f}, {1, 0.0f}, {2, 0.0f}, {4, 0.01f}, {10, 0.05f}, {40, 0.3f}}) {
    const Rendering frame = render_cut(parity_case, mode, cut);
    const Error error = composite_error(parity_case.camera_image, frame.buffers, endless.buffers);
    const frame::TruncationBound& bound = frame.statistics.truncation_bound;
    std::cout << std::left << std::setw(18) << parity_case.name << std::setw(7) << light
              << std::setw(10) << mode_name(mode) << std::right << std::setw(5) << cut.depth
              << std::setw(9) << cut.importance << std::fixed << std::setprecision(5)
              << std::setw(13) << error.mean << std::setw(9) << bound.mean << std::setw(9)
              << error.worst << std::setw(9) << bound.worst << std::defaultfloat << '\n';
    constexpr double kRounding = 1e-5;  // of sums in float
    EXPECT_LE(error.mean, bound.mean + rest.mean + kRounding);
    EXPECT_LE(error.worst, bound.worst + rest.worst + kRounding);
    if (cut.depth == 0) {
      EXPECT_GT(error.mean, 1e-3) << "nothing was cut off";
    }
  }
}

TEST(TruncationBound, HoldsOnEveryFrame) {
  std::cout << "scene             lamps  renderer  depth  cut-off   mean error    bound    worst"
               "    bound\n";
  for (const char* scene : {"complex", "mirror", "glassware"}) {
    ParityCase parity_case = make_parity_case(scene, 64, 48);
    hold_bound(parity_case, frame::RendererMode::Raytrace, "bright");
    hold_bound(parity_case, frame::RendererMode::Hybrid, "bright");
    dim_lamps(parity_case.scene);
    hold_bound(parity_case, frame::RendererMode::Raytrace, "dim");
  }
}

}  // namespace
}  // namespace amalgam::parity
