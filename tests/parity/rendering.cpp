#include "parity/rendering.h"

namespace amalgam::parity {

Rendering render(const ParityCase& parity_case, frame::RendererSettings settings) {
  settings.exposure = parity_case.exposure;
  settings.samples_per_pixel = parity_case.samples_per_side * parity_case.samples_per_side;
  settings.trace.max_depth = parity_case.max_depth;
  if (parity_case.exact_fresnel) settings.trace.fresnel = trace::FresnelModel::Exact;
  frame::FrameRenderer renderer(parity_case.scene, settings);
  frame::ViewOptions options;
  options.camera = parity_case.camera;
  options.keep_pixels = true;
  frame::ViewState view(options);
  Rendering result;
  frame::FrameOutput output =
      renderer.render(view, {parity_case.camera_image, parity_case.poses}, &result.buffers);
  result.composite = std::move(output.pixels);
  result.statistics = std::move(output.statistics);
  return result;
}

const char* mode_name(frame::RendererMode mode) {
  return mode == frame::RendererMode::Hybrid ? "hybrid" : "raytrace";
}

}  // namespace amalgam::parity
