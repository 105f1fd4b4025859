#include "report/composites.h"

#include "codec/jpeg.h"
#include "report/float_composite.h"
#include "report/picture_figures.h"

namespace amalgam::report {

Composites render_composites(bench::RenderRig& rig, const frame::FrameInput& input,
                             const common::ImageRgb8& camera_image, float render_scale) {
  frame::FrameBuffers buffers;
  frame::FrameOutput output = rig.render(input, &buffers);
  return {float_composite(frame_layers(buffers, camera_image.size(), render_scale), camera_image),
          as_light(codec::decode_jpeg(output.jpeg)), std::move(output.statistics)};
}

common::ImageRgb8 camera_image_of(const frame::FrameInput& input) {
  if (const auto* pixels = std::get_if<common::ImageRgb8>(&input.image)) return *pixels;
  return codec::decode_jpeg(std::get<frame::Bytes>(input.image));
}

float metered_exposure(const bench::BenchCase& bench_case) {
  return bench::RenderRig(bench_case, bench::default_settings()).render().statistics.exposure.y;
}

}  // namespace amalgam::report
