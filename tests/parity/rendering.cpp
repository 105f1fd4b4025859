#include "parity/rendering.h"

#include <algorithm>
#include <array>

#include "core/timings.h"

namespace amalgam::parity {
namespace {

frame::RendererSettings settings_of(const ParityCase& parity_case,
                                    frame::RendererSettings settings) {
  settings.exposure = parity_case.exposure;
  settings.samples_per_pixel = parity_case.samples_per_side * parity_case.samples_per_side;
  settings.trace.max_depth = parity_case.max_depth;
  settings.trace.importance_cutoff = parity_case.importance_cutoff;
  if (parity_case.by_difference) settings.real_surfaces = scene::RealSurfaces::Difference;
  if (parity_case.linear_response) settings.tone_curve = scene::ToneCurve::Linear;
  if (parity_case.exact_fresnel) settings.trace.fresnel = trace::FresnelModel::Exact;
  return settings;
}

// The pixels are asked for: what nobody asks for is not computed.
frame::ViewOptions view_options(const ParityCase& parity_case) {
  frame::ViewOptions options;
  options.camera = parity_case.camera;
  options.keep_pixels = true;
  return options;
}

}  // namespace

Rendering render(const ParityCase& parity_case, const frame::RendererSettings& settings) {
  frame::FrameRenderer renderer(parity_case.scene, settings_of(parity_case, settings));
  frame::ViewState view(view_options(parity_case));
  Rendering result;
  frame::FrameOutput output =
      renderer.render(view, {parity_case.camera_image, parity_case.poses}, &result.buffers);
  result.composite = std::move(output.pixels);
  result.statistics = std::move(output.statistics);
  return result;
}

double median_frame_time(const ParityCase& parity_case, const frame::RendererSettings& settings) {
  frame::FrameRenderer renderer(parity_case.scene, settings_of(parity_case, settings));
  frame::ViewState view(view_options(parity_case));
  const frame::FrameInput input{parity_case.camera_image, parity_case.poses};
  renderer.render(view, input);  // what is made once
  std::array<double, 5> times{};
  for (double& time : times) {
    const core::Stopwatch stopwatch;
    renderer.render(view, input);
    time = stopwatch.milliseconds();
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

const char* mode_name(frame::RendererMode mode) {
  return mode == frame::RendererMode::Hybrid ? "hybrid" : "raytrace";
}

}  // namespace amalgam::parity
