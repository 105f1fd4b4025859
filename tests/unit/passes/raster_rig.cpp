#include "unit/passes/raster_rig.h"

namespace amalgam::test_support {
namespace {

template <typename T>
std::optional<T> realise(graph::FrameGraph& graph, graph::Handle<T> handle) {
  const T* value = graph.realise(handle);
  return value != nullptr ? std::optional<T>(*value) : std::nullopt;
}

std::optional<common::ImageRgba32f> read(graph::FrameGraph& graph,
                                         graph::Handle<passes::DeviceImage> handle) {
  const auto image = realise(graph, handle);
  return image ? std::optional(passes::read_rgba(*image)) : std::nullopt;
}

}  // namespace

std::shared_ptr<gl::EglContext> shared_context() {
  static const auto context = std::make_shared<gl::EglContext>();
  return context;
}

const graph::PassReport& RasterFrame::report(const std::string& pass) const {
  for (const graph::PassReport& report : reports) {
    if (report.name == pass) return report;
  }
  AMALGAM_CHECK(false, "no pass '" + pass + "'");
}

RasterRig::RasterRig(const scene::Scene& scene)
    : context_(shared_context()), scene_(scene), shaders_(gl::find_features(scene)) {}

RasterFrame RasterRig::render(const passes::RenderView& view, float exposure,
                              scene::RealSurfaces real_surfaces) {
  graph::FrameGraph graph;
  const passes::RasterContext raster{*context_, shaders_, scene_, targets_};
  const auto uploaded = passes::add_upload_view_pass(graph, {raster, view});
  const auto mask = passes::add_mask_pass(graph, {raster, view, uploaded.device_view});
  const auto shadows = passes::add_shadow_maps_pass(
      graph, {raster, view, uploaded.device_view, shadows_, shadow_options});
  const auto reached =
      passes::add_reached_tiles_pass(graph, {raster, view, mask, shadows, !leave_out_tiles});
  const auto diffuse =
      passes::add_diffuse_pass(graph, {raster, view, uploaded.device_view, mask, shadows, reached});
  const auto effect = passes::add_effect_pass(graph, {raster, view, diffuse, reached});
  const auto real_depth =
      passes::add_real_depth_pass(graph, {raster, view, uploaded.device_view, mask.specular});
  const auto resolve = passes::add_resolve_pass(
      graph,
      {view, effect.effect, graph.import("tone map", scene::tone_map_of(exposure)), real_surfaces});

  RasterFrame frame;
  frame.mask = realise(graph, mask.mask);
  frame.counts = realise(graph, mask.counts);
  frame.real_depth = realise(graph, real_depth.depth);
  if (!leave_out_tiles) {
    frame.mixed = read(graph, diffuse.mixed);
    frame.real = read(graph, diffuse.real);
  }
  if (const auto* tiles = graph.realise(reached)) frame.reached = tiles->tiles;
  frame.layers = realise(graph, resolve.layers);
  frame.nonfinite = realise(graph, resolve.nonfinite).value_or(0);
  frame.diffuse_effect = graph.realise(effect.effect) != nullptr;
  frame.reports = graph.reports();
  return frame;
}

}  // namespace amalgam::test_support
