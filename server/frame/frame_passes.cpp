#include "frame/frame_passes.h"

#include <algorithm>

#include "frame/nothing_in_view.h"
#include "passes/image/look_up.h"
#include "passes/image/merge.h"
#include "passes/image/warp.h"
#include "passes/raster/raster_meter.h"
#include "passes/raster/reached_tiles.h"
#include "passes/raster/real_depth.h"
#include "passes/raster/resolve.h"
#include "passes/raster/shadow_bound.h"
#include "passes/raster/upload_view.h"

namespace amalgam::frame {
namespace {

constexpr const char* kNoSpecular = "no specular object in the scene";

// Why this frame cannot show anything virtual, whatever the camera image; nothing if it might.
std::optional<std::string> reason_for_nothing(const SceneResources& resources,
                                              const FrameRequest& request) {
  const passes::RenderView& view = request.render_view;
  if (!resources.features.has_virtual) return "no virtual object in the scene";
  const auto& instances = view.scene.instances;
  const bool any_virtual =
      std::any_of(instances.begin(), instances.end(), [&](const auto& anchored) {
        return resources.scene.instances[anchored.instance].role == scene::Role::Virtual;
      });
  if (!any_virtual) return "no pose of a marker that a virtual object stands on";
  // A dump contains the buffers even if they are empty.
  if (!request.keep_buffers &&
      nothing_virtual_in_view(resources.scene, resources.mesh_bounds, view))
    return "nothing virtual in view";
  return std::nullopt;
}

passes::ExposureInputs exposure_inputs(const SceneResources& resources, const FrameRequest& request,
                                       const FramePasses& frame) {
  return {.fixed = request.settings.exposure,
          .curve = request.settings.tone_curve,
          .card = request.settings.exposure_card,
          .white_balance = request.settings.white_balance,
          .camera = request.render_view.camera,
          .ideal = request.render_view.ideal,
          .markers = {request.input.poses, resources.scene.world.marker_length},
          .grid = frame.meter_grid,
          .camera_image = frame.camera_image,
          .memory = request.view.exposure};
}

passes::TraceInputs trace_inputs(const SceneResources& resources, const FrameRequest& request,
                                 const FramePasses& frame) {
  return {.view = request.render_view,
          .environment = resources.surroundings.map(),
          .largest_environment = resources.surroundings.largest,
          .settings = request.settings.trace,
          .keep_images = request.keep_buffers,
          .keep_provenance = request.keep_buffers || request.view.options.keep_provenance,
          .keep_paths_below = request.keep_still ? StillView::kMostBytes : 0,
          .ray_log = request.settings.ray_log,
          .specular = frame.mask.specular,
          .mask = frame.mask.mask,
          .scene = frame.placed,
          .camera_image = frame.camera_image,
          .tone_map = frame.tone_map,
          .real_surfaces = request.settings.real_surfaces,
          .real_depth = frame.real_depth,
          .virtual_shadows = frame.virtual_shadows};
}

// Rasterise what is diffuse, trace what is specular.
void add_hybrid_passes(graph::FrameGraph& graph, const SceneResources& resources,
                       const FrameRequest& request, FramePasses& frame) {
  const auto& nothing = frame.nothing;
  const passes::RasterContext& raster = *resources.raster;
  const passes::RenderView& view = request.render_view;
  const auto device_view = nothing
                               ? graph.absent<passes::DeviceView>("device view", *nothing)
                               : passes::add_upload_view_pass(graph, {raster, view}).device_view;
  const auto shadows = passes::add_shadow_maps_pass(
      graph,
      {.raster = raster, .view = view, .device_view = device_view, .cache = *resources.shadows});
  frame.mask = passes::add_mask_pass(graph, {raster, view, device_view});
  // A dump shows I_m and I_r everywhere.
  const bool all_tiles = !request.settings.leave_out_tiles || request.keep_buffers;
  const auto reached =
      passes::add_reached_tiles_pass(graph, {raster, view, frame.mask, shadows, all_tiles});
  frame.diffuse =
      passes::add_diffuse_pass(graph, {raster, view, device_view, frame.mask, shadows, reached});
  frame.effect = passes::add_effect_pass(graph, {raster, view, frame.diffuse, reached}).effect;
  frame.meter_grid =
      passes::add_raster_meter_pass(graph, {raster, view, device_view, frame.mask, shadows});
  frame.tone_map = passes::add_exposure_pass(graph, exposure_inputs(resources, request, frame));
  const auto resolved = passes::add_resolve_pass(
      graph, {view, frame.effect, frame.tone_map, request.settings.real_surfaces});
  frame.rasterised = resolved.layers;
  frame.rasterised_nonfinite = resolved.nonfinite;

  if (!resources.features.has_specular) {
    graph.note_left_out("real depth", kNoSpecular);
    graph.note_left_out("trace", kNoSpecular);
    frame.virtual_shadows =
        graph.absent<passes::VirtualShadows>("virtual shadow bound", kNoSpecular);
    frame.real_depth = graph.absent<passes::RealDepth>("real-only depth", kNoSpecular);
    frame.traced = graph.absent<trace::TraceResult>("traced layers", kNoSpecular);
    return;
  }
  frame.virtual_shadows =
      request.settings.leave_out_tiles
          ? passes::add_shadow_bound_pass(graph, shadows)
          : graph.absent<passes::VirtualShadows>("virtual shadow bound",
                                                 "the settings leave nothing out by tile");
  frame.real_depth =
      passes::add_real_depth_pass(graph, {raster, view, device_view, frame.mask.specular}).depth;
  frame.traced = passes::add_trace_pass(graph, trace_inputs(resources, request, frame));
}

// Makes the resources absent that only rasterising makes.
void leave_out_rasterised(graph::FrameGraph& graph, const std::string& reason, FramePasses& frame) {
  frame.mask.device = graph.absent<passes::DeviceMask>("device mask", reason);
  frame.mask.mask = graph.absent<passes::SampleMask>("M_v and M_r", reason);
  frame.mask.counts = graph.absent<passes::SampleCounts>("sample counts", reason);
  frame.mask.diffuse = graph.absent<passes::DiffuseSamples>("diffuse samples", reason);
  frame.diffuse.mixed = graph.absent<passes::DeviceImage>("I_m", reason);
  frame.diffuse.real = graph.absent<passes::DeviceImage>("I_r", reason);
  frame.effect = graph.absent<passes::DiffuseEffect>("diffuse effect", reason);
  frame.rasterised = graph.absent<passes::Layers>("diffuse layers", reason);
  frame.rasterised_nonfinite = graph.absent<std::uint64_t>("non-finite diffuse values", reason);
  frame.virtual_shadows = graph.absent<passes::VirtualShadows>("virtual shadow bound", reason);
  frame.real_depth = graph.absent<passes::RealDepth>("real-only depth", reason);
}

// Trace every sample.
void add_raytrace_passes(graph::FrameGraph& graph, const SceneResources& resources,
                         const FrameRequest& request, FramePasses& frame) {
  const auto& nothing = frame.nothing;
  const passes::RenderView& view = request.render_view;
  frame.mask.specular = nothing
                            ? graph.absent<passes::SpecularSamples>("samples to trace", *nothing)
                            : graph.import("samples to trace", passes::SpecularSamples{});
  leave_out_rasterised(graph, nothing.value_or("every sample is traced"), frame);
  frame.meter_grid = passes::add_traced_meter_pass(
      graph, {.view = view, .environment = resources.surroundings.map(), .scene = frame.placed});
  frame.tone_map = passes::add_exposure_pass(graph, exposure_inputs(resources, request, frame));
  frame.traced = passes::add_trace_pass(graph, trace_inputs(resources, request, frame));
}

template <typename T, typename Value>
graph::Handle<T> bring_back(graph::FrameGraph& graph, const char* name, const Kept<Value>& kept,
                            T value) {
  return kept.value ? graph.import(name, std::move(value)) : graph.absent<T>(name, kept.reason);
}
template <typename T>
graph::Handle<T> bring_back(graph::FrameGraph& graph, const char* name, const Kept<T>& kept) {
  return bring_back(graph, name, kept, kept.value.value_or(T()));
}

// Nothing moved: an equal frame's results, with this frame's camera image.
void add_still_passes(graph::FrameGraph& graph, const SceneResources& resources,
                      const FrameRequest& request, FramePasses& frame) {
  const StillFrame& still = *request.still;
  for (const char* pass : {"mask", "reached tiles", "diffuse", "effect", "meter", "trace"})
    graph.note_left_out(pass, passes::kNothingMoved);
  leave_out_rasterised(graph, passes::kNothingMoved, frame);
  frame.mask.specular =
      graph.absent<passes::SpecularSamples>("samples to trace", passes::kNothingMoved);
  frame.mask.counts = bring_back(graph, "sample counts", still.counts);
  frame.meter_grid = bring_back(graph, "meter grid", still.meter_grid);
  frame.tone_map = passes::add_exposure_pass(graph, exposure_inputs(resources, request, frame));
  const passes::ShadedTiles* shaded = still.shaded.value ? &*still.shaded.value : nullptr;
  frame.effect = bring_back(graph, "diffuse effect", still.shaded, passes::DiffuseEffect{shaded});
  const auto resolved = passes::add_resolve_pass(
      graph, {request.render_view, frame.effect, frame.tone_map, request.settings.real_surfaces});
  frame.rasterised = resolved.layers;
  frame.rasterised_nonfinite = resolved.nonfinite;
  const auto paths = bring_back(graph, "traced paths", still.paths);
  frame.traced = passes::add_look_up_pass(
      graph, {paths, frame.camera_image, frame.tone_map, request.settings.real_surfaces});
}

// Adaptive: nine samples at edges. Traced shadow edges (hybrid): as many samples as elsewhere, but
// traced, at shadow edges.
void add_refinement(graph::FrameGraph& graph, const SceneResources& resources,
                    const FrameRequest& request, FramePasses& frame) {
  const RendererSettings& settings = request.settings;
  const bool traced_edges = settings.trace_shadow_edges && resources.raster != nullptr;
  if (!settings.adaptive_threshold && !traced_edges) {
    frame.refinement = graph.absent<passes::Refinement>(
        "refinement", settings.trace_shadow_edges ? "every sample is traced"
                                                  : "the settings ask for no refinement");
    return;
  }
  const bool adaptive = settings.adaptive_threshold.has_value();
  const auto refined = passes::add_refine_pass(
      graph, {.trace = trace_inputs(resources, request, frame),
              .threshold = settings.adaptive_threshold.value_or(passes::kShadowEdgeThreshold),
              .samples_per_side =
                  adaptive ? passes::kAdaptiveSamplesPerSide : request.render_view.samples_per_side,
              .by_surface = adaptive,
              .base = frame.layers});
  frame.layers = refined.layers;
  frame.refinement = refined.statistics;
}

}  // namespace

FramePasses add_frame_passes(graph::FrameGraph& graph, const SceneResources& resources,
                             const FrameRequest& request) {
  FramePasses frame;
  frame.nothing = reason_for_nothing(resources, request);
  const bool still = request.still != nullptr && !frame.nothing;
  const bool wants_own_quality = request.view.options.jpeg_quality != 0;
  const auto decoded = passes::add_decode_pass(graph, {.image = request.input.image,
                                                       .camera = request.render_view.camera,
                                                       .keep_coefficients = !wants_own_quality});
  frame.camera_image = decoded.camera_image;
  if (still) {
    graph.note_left_out("place instances", passes::kNothingMoved);
    frame.placed = graph.absent<passes::PlacedScene>("placed scene", passes::kNothingMoved);
  } else if (resources.embree != nullptr) {
    frame.placed = passes::add_place_instances_pass(graph, request.render_view, *resources.embree);
  } else {
    graph.note_left_out("place instances", kNoSpecular);
    frame.placed = graph.absent<passes::PlacedScene>("placed scene", kNoSpecular);
  }
  if (still) {
    add_still_passes(graph, resources, request, frame);
  } else if (resources.raster != nullptr) {
    add_hybrid_passes(graph, resources, request, frame);
  } else {
    add_raytrace_passes(graph, resources, request, frame);
  }
  frame.layers = passes::add_merge_pass(graph, {frame.rasterised, frame.traced});
  add_refinement(graph, resources, request, frame);
  auto layers = frame.layers;
  const float scale = request.settings.render_scale;
  const common::CameraModel& camera = request.view.options.camera;
  if (request.view.warp_map || scale < 1.0f) {
    const auto& map = request.view.warp_map;
    layers = passes::add_warp_pass(
        graph, frame.layers,
        {.size = {camera.width, camera.height}, .lens = map ? &*map : nullptr, .scale = scale});
  } else {
    graph.note_left_out("warp", "the lens does not distort");
  }
  frame.composite = passes::add_composite_pass(graph, {.layers = layers,
                                                       .camera_image = frame.camera_image,
                                                       .tone_map = frame.tone_map,
                                                       .even_if_unchanged = wants_own_quality});
  frame.encoded = passes::add_encode_pass(
      graph, {.composite = frame.composite,
              .coefficients = decoded.coefficients,
              .quality = wants_own_quality ? request.view.options.jpeg_quality
                                           : request.settings.jpeg_quality,
              .camera = &request.input.image});
  return frame;
}

}  // namespace amalgam::frame
