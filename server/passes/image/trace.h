// The tracer as a pass: what the specular samples of this frame show.
#pragma once

#include <vector>

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/image/decode.h"
#include "passes/image/exposure_meter.h"
#include "scene/light/environment.h"
#include "trace/tracer.h"

namespace amalgam::passes {

// An Embree scene whose instances are where this frame has them.
struct PlacedScene {
  const trace::EmbreeScene* scene = nullptr;
};

// Moves the instances; left out if nothing moved.
graph::Handle<PlacedScene> add_place_instances_pass(graph::FrameGraph& graph,
                                                    const RenderView& view,
                                                    trace::EmbreeScene& scene);

struct TraceInputs {
  const RenderView& view;
  const scene::Environment* environment = nullptr;
  trace::TraceSettings settings;
  bool keep_images = false;
  bool keep_provenance = false;
  // 0: the trace pass keeps no paths; otherwise it does up to so many bytes (trace_request.h).
  std::size_t keep_paths_below = 0;
  trace::RayLog* ray_log = nullptr;
  graph::Handle<SpecularSamples> specular;
  graph::Handle<SampleMask> mask;  // may be absent: every sample is traced
  graph::Handle<PlacedScene> scene;
  graph::Handle<CameraImage> camera_image;
  graph::Handle<float> exposure;
  graph::Handle<RealDepth> real_depth;            // may be absent: look-ups then ask by rays
  graph::Handle<VirtualShadows> virtual_shadows;  // may be absent: every shadow is asked by rays
};

graph::Handle<trace::TraceResult> add_trace_pass(graph::FrameGraph& graph, const TraceInputs& in);

// Which samples to trace: size ideal.size * per_side, those with the bit. Null flags: all.
struct TracedSamples {
  const common::Image<std::uint8_t>* flags = nullptr;
  std::uint8_t bit = 0;
  int per_side = 1;
  std::size_t keep_paths_below = 0;
};

// What every pass that calls trace_samples reads.
void declare_trace_reads(graph::Builder& builder, const TraceInputs& in);

// The tracing itself, for a pass that has called declare_trace_reads.
trace::TraceResult trace_samples(const TraceInputs& in, const graph::Access& access,
                                 const TracedSamples& samples);

struct TracedMeterInputs {
  const RenderView& view;
  const scene::Environment* environment = nullptr;
  graph::Handle<PlacedScene> scene;
};

// The exposure meter's grid by tracing, for where nothing is rasterised.
graph::Handle<MeterGrid> add_traced_meter_pass(graph::FrameGraph& graph,
                                               const TracedMeterInputs& in);

}  // namespace amalgam::passes
