// The bound that each frame states, held against the error that it is a bound of: scenes that come
// with Amalgam, rendered by both methods at many depths and cut-offs, against rays that almost
// never end.
#include <gtest/gtest.h>

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "parity/rendering.h"
#include "scene/light/tone_map.h"

namespace amalgam::parity {
namespace {

struct Error {
  double mean = 0.0, worst = 0.0;  // display-linear
};

template <typename Image>
Image layer(const frame::FrameBuffers& buffers, const char* name, glm::ivec2 size) {
  const auto found = buffers.find(name);
  return found != buffers.end() ? std::get<Image>(found->second) : Image(size.x, size.y);
}

// Of the composites before they are rounded to bytes. The lens of the cases does not distort.
Error composite_error(const common::ImageRgb8& image, const frame::FrameBuffers& a,
                      const frame::FrameBuffers& b) {
  const glm::ivec2 size = image.size();
  const auto over_a = layer<common::ImageRgba32f>(a, "over", size),
             over_b = layer<common::ImageRgba32f>(b, "over", size);
  const auto difference_a = layer<common::ImageRgb32f>(a, "difference", size),
             difference_b = layer<common::ImageRgb32f>(b, "difference", size);
  Error error;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const glm::vec4 over = over_a.at(x, y) - over_b.at(x, y);
      const glm::vec3 change =
          glm::abs(glm::vec3(over) - over.w * scene::srgb_decode(image.at(x, y)) +
                   difference_a.at(x, y) - difference_b.at(x, y));
      error.mean += double{change.x + change.y + change.z} / 3.0;
      error.worst = std::max(error.worst, double{std::max({change.x, change.y, change.z})});
    }
  }
  error.mean /= static_cast<double>(size.x) * size.y;
  return error;
}

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
