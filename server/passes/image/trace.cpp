#include "passes/image/trace.h"

#include <algorithm>
#include <memory>

namespace amalgam::passes {

graph::Handle<PlacedScene> add_place_instances_pass(graph::FrameGraph& graph,
                                                    const RenderView& view,
                                                    trace::EmbreeScene& scene) {
  if (scene.is_placed(view.scene)) {
    graph.note_left_out("place instances", kNothingMoved);
    return graph.import("placed scene", PlacedScene{&scene});
  }
  graph::Builder builder = graph.add_pass("place instances");
  const auto out = builder.writes<PlacedScene>("placed scene");
  builder.runs([out, &view, &scene](const graph::Access& access) {
    scene.place(view.scene);
    access.set(out, PlacedScene{&scene});
  });
  return out;
}

void declare_trace_reads(graph::Builder& builder, const TraceInputs& in) {
  builder.needs(in.scene);
  builder.needs(in.camera_image);
  builder.needs(in.tone_map);
  builder.uses(in.real_depth);
  builder.uses(in.virtual_shadows);
}

trace::TraceResult trace_samples(const TraceInputs& in, const graph::Access& access,
                                 const TracedSamples& samples) {
  const RealDepth* real_depth = access.find(in.real_depth);
  const VirtualShadows* virtual_shadows = access.find(in.virtual_shadows);
  const trace::CameraView lookup{
      .camera = in.view.camera,
      .camera_from_world = in.view.scene.camera_from_world,
      .ideal = in.view.ideal,
      .real_depth = real_depth != nullptr ? &real_depth->z : nullptr,
  };
  return trace::trace({
      .scene = *access.get(in.scene).scene,
      .lights = in.view.lights,
      .environment = in.environment,
      .largest_environment = in.largest_environment,
      .camera = in.view.ideal,
      .camera_from_world = in.view.scene.camera_from_world,
      .samples_per_side = samples.per_side,
      .mask = samples.flags,
      .mask_bit = samples.bit,
      .virtual_shadows = virtual_shadows != nullptr ? virtual_shadows->get() : nullptr,
      .lookup = &lookup,
      .camera_image = &access.get(in.camera_image).pixels,
      .tone_map = access.get(in.tone_map),
      .real_surfaces = in.real_surfaces,
      .settings = in.settings,
      .keep_images = in.keep_images,
      .keep_provenance = in.keep_provenance,
      .keep_paths_below = samples.keep_paths_below,
      .ray_log = in.ray_log,
      .progress = in.view.progress,
  });
}

graph::Handle<trace::TraceResult> add_trace_pass(graph::FrameGraph& graph, const TraceInputs& in) {
  graph::Builder builder = graph.add_pass("trace");
  builder.needs(in.specular);
  builder.uses(in.mask);
  declare_trace_reads(builder, in);
  const auto out = builder.writes<trace::TraceResult>("traced layers");
  builder.runs([in, out](const graph::Access& access) {
    const SampleMask* mask = access.find(in.mask);
    const TracedSamples samples{mask != nullptr ? &mask->flags : nullptr, SampleMask::kSpecular,
                                in.view.samples_per_side, in.keep_paths_below};
    access.set(out, trace_samples(in, access, samples));
  });
  return out;
}

namespace {

// Depth 0: only directly seen surfaces matter.
trace::TraceResult trace_meter(const TracedMeterInputs& in, const graph::Access& access,
                               const common::Image<std::uint8_t>& mask, bool white_surfaces) {
  return trace::trace({
      .scene = *access.get(in.scene).scene,
      .lights = in.view.lights,
      .environment = in.environment,
      .camera = in.view.ideal,
      .camera_from_world = in.view.scene.camera_from_world,
      .samples_per_side = in.view.samples_per_side,
      .mask = &mask,
      .mask_bit = 1,
      .white_surfaces = white_surfaces,
      .settings = {.max_depth = 0},
      .keep_images = true,
      .progress = in.view.progress,
  });
}

}  // namespace

graph::Handle<MeterGrid> add_traced_meter_pass(graph::FrameGraph& graph,
                                               const TracedMeterInputs& in) {
  graph::Builder builder = graph.add_pass("meter");
  builder.needs(in.scene);
  const auto out = builder.writes<MeterGrid>("meter grid");
  builder.runs([in, out](const graph::Access& access) {
    const int n = in.view.samples_per_side;
    const glm::ivec2 size = glm::ivec2(in.view.ideal.width, in.view.ideal.height) * n;
    const int step = meter_step(size);
    const auto entry = [&](int i, int side) { return std::min(i * step + step / 2, side - 1); };
    const glm::ivec2 entries = (size + step - 1) / step;
    common::Image<std::uint8_t> mask(size.x, size.y);
    for (int y = 0; y < entries.y; ++y) {
      for (int x = 0; x < entries.x; ++x) mask.at(entry(x, size.x), entry(y, size.y)) = 1;
    }
    const auto trace_grid = [&](bool white_surfaces) {
      const trace::TraceResult traced = trace_meter(in, access, mask, white_surfaces);
      common::ImageRgba32f grid(entries.x, entries.y);
      for (int y = 0; y < entries.y; ++y) {
        for (int x = 0; x < entries.x; ++x) {
          grid.at(x, y) = traced.images->real.at(entry(x, size.x) / n, entry(y, size.y) / n);
        }
      }
      return grid;
    };
    access.set(out, MeterGrid{trace_grid(false), trace_grid(true), step, n});
  });
  return out;
}

}  // namespace amalgam::passes
