// One line of the parity table: how far the renderer is from the reference in one case.
#pragma once

#include <string>

#include "frame/frame_renderer.h"
#include "parity/parity_case.h"
#include "parity/rendering.h"

namespace amalgam::parity {

// A traced pixel agrees if every channel of I_m, I_e and, where M_v is 0, I_r (which eq. 4.5 uses
// only there) is within this of the reference's (support/reference/relative_error.h).
constexpr double kTracedTolerance = 2e-3;
// Of traced pixels that are compared; a float's rounding, seen through a few surfaces.
constexpr double kTracedMean = 2e-5;

struct ParityRow {
  std::size_t pixels = 0;
  std::uint64_t nonfinite = 0;  // values that the renderer replaced by 0
  // Pixels that the tracer is responsible for, by the reference.
  std::size_t traced = 0;
  // Of those: left out of the comparison, see reference::Grazing.
  std::size_t edge = 0;
  std::size_t steep = 0;
  std::size_t rim = 0;  // hybrid: whether the rasteriser leaves the pixel to the tracer is chance
  double traced_mean = 0.0;              // relative error, without grazing pixels
  double traced_maximum = 0.0;           // likewise
  std::size_t traced_wrong = 0;          // over tolerance, without grazing pixels
  std::size_t traced_wrong_grazing = 0;  // over tolerance, grazing pixels
  // The composite, in 1/255.
  double composite_mean = 0.0;
  double composite_maximum = 0.0;
  std::size_t composite_wrong = 0;             // pixels off by more than 3
  std::size_t composite_wrong_rasterised = 0;  // of those: rasterised

  // For a failing test: the worst pixels in words, the error of each traced pixel that counts, and
  // the pictures.
  std::string worst;
  common::Image<double> traced_errors;
  common::ImageRgb32f mixed, real;
  common::ImageRgb8 composite;
};

// Of a picture made in that mode; expected: with grazing pixels found.
ParityRow compare_rendering(Rendering actual, const reference::ReferenceImages& expected,
                            frame::RendererMode mode);

// mode: Hybrid (traced pixels are those of M_r) or Raytrace (all are). Hybrid traces the edges of
// shadows: shadow maps alone are exact to a texel.
ParityRow compare_with_reference(const ParityCase& parity_case, frame::RendererMode mode);

std::string table_header();
std::string table_line(const ParityCase& parity_case, frame::RendererMode mode,
                       const ParityRow& row);

}  // namespace amalgam::parity
