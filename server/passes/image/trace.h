// The tracer as a pass: traces the specular samples of a frame.
#pragma once

#include <vector>

#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/image/decode.h"
#include "passes/image/meter_grid.h"
#include "scene/light/environment.h"
#include "trace/tracer.h"

namespace amalgam::passes {

// An Embree scene whose instances have this frame's transforms.
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
  glm::vec3 largest_environment{0.0f};  // scene::largest_radiance(*environment)
  trace::TraceSettings settings;
  bool keep_images = false;
  bool keep_provenance = false;
  // Bytes: the trace pass keeps paths up to this size; 0: none (trace_request.h).
  std::size_t keep_paths_below = 0;
  trace::RayLog* ray_log = nullptr;
  graph::Handle<SpecularSamples> specular;
  graph::Handle<SampleMask> mask;  // may be absent: every sample is traced
  graph::Handle<PlacedScene> scene;
  graph::Handle<CameraImage> camera_image;
  graph::Handle<scene::ToneMap> tone_map;
  scene::RealSurfaces real_surfaces = scene::RealSurfaces::Ratio;
  // may be absent: look-ups then cast visibility rays
  graph::Handle<RealDepth> real_depth;
  graph::Handle<VirtualShadows> virtual_shadows;  // may be absent: every shadow ray is then cast
};

graph::Handle<trace::TraceResult> add_trace_pass(graph::FrameGraph& graph, const TraceInputs& in);

// The samples to trace: those with the bit in flags, of size ideal.size * per_side. Null flags:
// all.
struct TracedSamples {
  const common::Image<std::uint8_t>* flags = nullptr;
  std::uint8_t bit = 0;
  int per_side = 1;
  std::size_t keep_paths_below = 0;
};

// Declares the reads of a pass that calls trace_samples.
void declare_trace_reads(graph::Builder& builder, const TraceInputs& in);

// Traces, for a pass that has called declare_trace_reads.
trace::TraceResult trace_samples(const TraceInputs& in, const graph::Access& access,
                                 const TracedSamples& samples);

struct TracedMeterInputs {
  const RenderView& view;
  const scene::Environment* environment = nullptr;
  graph::Handle<PlacedScene> scene;
};

// The exposure meter's grid by tracing, for modes without rasterising.
graph::Handle<MeterGrid> add_traced_meter_pass(graph::FrameGraph& graph,
                                               const TracedMeterInputs& in);

}  // namespace amalgam::passes
