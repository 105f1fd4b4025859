// Our composites onto a truth pair's camera image.
#pragma once

#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "truth/truth_case.h"

namespace amalgam::truth {

// A way to make the composite.
struct Method {
  std::string name;
  frame::RendererSettings settings;
};

Method by_default();
// The default, but for more lights: slower, and nearer to the truth.
Method with_64_lights();
// Eq. 4.5 with its eight lights: by difference, the real surfaces for a grey card, Reinhard's
// curve.
Method of_the_thesis();
// 64 lights, each time with one part switched off.
std::vector<Method> parts_off();

// One scene with one method. Belongs to the thread that made it.
class TruthRenderer {
 public:
  TruthRenderer(const TruthCase& truth_case, const Method& method);

  void light_by(const Environment& environment);
  // The exposure is metered on the picture, as for any client.
  common::ImageRgb8 composite(const common::ImageRgb8& camera);
  // M_v.
  common::Image32f virtual_mask(const common::ImageRgb8& camera);

 private:
  frame::FrameOutput render(const common::ImageRgb8& camera, frame::FrameBuffers* buffers);

  TruthCase truth_case_;
  frame::FrameRenderer renderer_;
};

}  // namespace amalgam::truth
