#include "frame/frame_renderer.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

#include "common/check_context.h"
#include "core/flush_denormals.h"
#include "frame/buffer_dump.h"
#include "frame/costs.h"
#include "frame/frame_passes.h"
#include "frame/frame_provenance.h"
#include "frame/rendering_threads.h"
#include "frame/replay_text.h"
#include "frame/scene_variant.h"
#include "frame/still_frame.h"
#include "gl/shader_interface.h"
#include "passes/image/light_extraction.h"
#include "scene/anchored_scene.h"
#include "scene/features.h"
#include "scene/light/env_lights.h"

namespace amalgam::frame {
namespace {

// Resources for rasterising, made only for modes that rasterise.
struct Raster {
  explicit Raster(const scene::Scene& scene)
      : shaders(gl::find_features(scene)),
        gpu_scene(scene),
        passes{context, shaders, gpu_scene, targets} {}
  gl::EglContext context;
  gl::ShaderLibrary shaders;
  gl::GpuScene gpu_scene;
  passes::RasterTargets targets;
  passes::ShadowCache shadows;
  passes::RasterContext passes;
};

FrameStatistics collect_statistics(const graph::FrameGraph& graph, const FramePasses& frame,
                                   const passes::RenderView& view) {
  FrameStatistics statistics;
  for (const graph::PassReport& report : graph.reports()) {
    statistics.passes.push_back({report.name, report.ran, report.reason});
    if (report.ran) core::add_time(statistics.stages, report.name, report.milliseconds);
  }
  const auto samples = static_cast<std::uint64_t>(view.samples_per_side * view.samples_per_side);
  statistics.pixels.total =
      static_cast<std::uint64_t>(view.ideal.width) * static_cast<std::uint64_t>(view.ideal.height);
  core::TruncationBound truncation;
  if (const trace::TraceResult* traced = graph.peek(frame.traced)) {
    statistics.rays = traced->counts.rays;
    statistics.nonfinite += traced->nonfinite;
    truncation += traced->truncation;
    statistics.pixels.virtual_pixels = traced->counts.primary_virtual / samples;
    statistics.pixels.specular = traced->counts.primary_specular / samples;
  }
  if (const passes::SampleCounts* counts = graph.peek(frame.mask.counts)) {
    statistics.pixels.virtual_pixels = counts->virtual_surface / samples;
    statistics.pixels.specular = counts->specular / samples;
  }
  if (const passes::Refinement* refinement = graph.peek(frame.refinement)) {
    statistics.rays += refinement->rays;
    statistics.pixels.refined = refinement->pixels;
    statistics.nonfinite += refinement->nonfinite;
    // Refined pixels count twice, also as they were before: more than needed, but still a bound.
    truncation += refinement->truncation;
  }
  if (const auto* nonfinite = graph.peek(frame.rasterised_nonfinite)) {
    statistics.nonfinite += *nonfinite;
  }
  statistics.truncation_bound = {truncation.sum / static_cast<double>(statistics.pixels.total),
                                 std::min(truncation.worst, 1.0)};
  if (const auto* tone_map = graph.peek(frame.tone_map)) {
    statistics.exposure = tone_map->exposure;
    statistics.tone_curve = scene::tone_curve_name(tone_map->curve);
  }
  return statistics;
}

// The number of lights of a rasterised frame is limited. An environment may be set later, so its
// lights always count.
void check_light_count(const scene::Scene& scene, const scene::EnvLightOptions& options) {
  const int environment = scene::most_lights(options);
  const std::size_t punctual = scene.punctual_lights.size();
  if (static_cast<std::size_t>(environment) + punctual <= gl::kMaxLights) return;
  throw std::invalid_argument(
      "up to " + std::to_string(environment) + " lights of the environment and " +
      std::to_string(punctual) + " of the scene, but rasterising takes " +
      std::to_string(gl::kMaxLights) + "; tracing every pixel (raytrace) takes more");
}

}  // namespace

class FrameRenderer::Impl {
 public:
  Impl(scene::Scene scene, const RendererSettings& settings)
      : settings_(settings),
        scene_(scene_variant(std::move(scene), settings.mode)),
        surroundings_(make_surroundings(std::exchange(scene_.environment, std::nullopt))),
        features_(scene::scene_features(scene_)),
        mesh_bounds_(scene::mesh_bounds(scene_)),
        arena_(rendering_threads(settings)),
        owner_(std::this_thread::get_id()) {
    check_settings(settings);
    const bool traces_all = settings.mode == RendererMode::Raytrace;
    if (traces_all || features_.has_specular || settings.adaptive_threshold ||
        settings.trace_shadow_edges) {
      embree_.emplace(scene_);
    }
    if (traces_all) return;
    check_light_count(scene_, settings.env_lights);
    raster_.emplace(scene_);
  }

  FrameOutput render(ViewState& view, const FrameInput& input, FrameBuffers* buffers) {
    const common::CheckContext context([&] {
      return "rendering a frame; to replay it:\n" +
             replay_text(replayed_frame(view, input, buffers != nullptr));
    });
    AMALGAM_CHECK(std::this_thread::get_id() == owner_,
                  "rendering on a thread that is not the owner");
    FrameOutput output;
    const core::FlushDenormals flush_denormals;  // the arena's workers as well
    arena_.execute([&] { output = render_in_arena(view, input, buffers); });
    return output;
  }

  void set_environment(scene::Environment environment) {
    surroundings_ = make_surroundings(std::move(environment));
  }

  void set_own_environment(ViewState& view, scene::Environment environment) {
    view.own_surroundings = make_surroundings(std::move(environment));
  }

  void free_targets() {
    if (raster_) raster_->targets = {};
  }

  void make_current() {
    if (raster_) raster_->context.make_current();
  }

  std::string hardware() const {
    const std::string drawing = raster_ ? raster_->context.renderer() + "; " : "";
    return drawing + ray_tracer_version();
  }

  const scene::Scene& scene() const { return scene_; }
  const std::string& last_graph() const { return last_graph_; }

 private:
  FrameOutput render_in_arena(ViewState& view, const FrameInput& input, FrameBuffers* buffers) {
    const core::Stopwatch stopwatch;
    graph::FrameGraph graph;
    graph.watch(input.progress);
    Surroundings& surroundings = surroundings_of(view);
    passes::EnvironmentLights lights = environment_lights(graph, surroundings);
    const RendererSettings settings = settings_for(view);
    const passes::RenderView render_view =
        make_render_view(view, input, settings, std::move(lights));
    const SceneResources resources{
        .scene = scene_,
        .features = features_,
        .mesh_bounds = mesh_bounds_,
        .surroundings = surroundings,
        .embree = embree_ ? &*embree_ : nullptr,
        .raster = raster_ ? &raster_->passes : nullptr,
        .shadows = raster_ ? &raster_->shadows : nullptr,
    };
    begin_still(view, settings, render_view, buffers != nullptr);
    const FramePasses frame =
        add_frame_passes(graph, resources,
                         {settings, input, view, render_view, buffers != nullptr,
                          view.still.frame(), view.still.wants_frame()});

    FrameOutput output = take_output(graph, frame, view, input);
    if (buffers != nullptr) *buffers = collect_buffers(graph, frame, render_view);
    if (view.options.keep_provenance)
      output.provenance = frame_provenance(graph, frame, render_view);
    output.statistics = collect_statistics(graph, frame, render_view);
    core::add_time(output.statistics.stages, "total", stopwatch.milliseconds());
    if (view.governor) {
      output.statistics.quality = view.governor->report();
      const bool is_whole = !output.unchanged && view.still.frame() == nullptr;
      if (is_whole) view.governor->frame_done(frame_cost(output.statistics));
    }
    if (view.still.wants_frame() && !frame.nothing) {
      if (auto still = collect_still(graph, frame, render_view)) {
        view.still.keep(std::move(*still));
      } else {
        view.still.give_up();
      }
    }
    last_graph_ = graph.to_graphviz();
    return output;
  }

  std::shared_ptr<Surroundings> make_surroundings(std::optional<scene::Environment> environment) {
    return std::make_shared<Surroundings>(std::move(environment), made_surroundings_++);
  }

  Surroundings& surroundings_of(const ViewState& view) const {
    return view.own_surroundings ? *view.own_surroundings : *surroundings_;
  }

  // The settings have the quality that the governor chose, without the target that it chose by.
  ReplayedFrame replayed_frame(const ViewState& view, const FrameInput& input,
                               bool keep_buffers) const {
    ReplayedFrame frame{.scene_path = scene_.path,
                        .camera = view.options.camera,
                        .poses = input.poses,
                        .settings = chosen_settings(view),
                        .keep_provenance = view.options.keep_provenance,
                        .keep_buffers = keep_buffers,
                        .environment_replaced = surroundings_of(view).number > 0};
    frame.settings.target_fps.reset();
    frame.settings.coarse_allowed = false;
    if (view.still.wants_frame()) frame.repeat = 2;
    if (view.still.frame() != nullptr) frame.repeat = 3;
    return frame;
  }

  // The only pass that runs at once: the drawing depends on the number of lights.
  passes::EnvironmentLights environment_lights(graph::FrameGraph& graph,
                                               Surroundings& surroundings) const {
    const auto* lights = graph.realise(passes::add_light_extraction_pass(
        graph, {surroundings.map(), settings_.env_lights, surroundings.lights}));
    return lights != nullptr ? *lights : passes::EnvironmentLights{};
  }

  // The operator's settings; with a target frame rate, lowered by the governor.
  RendererSettings settings_for(ViewState& view) const {
    if (!settings_.target_fps) return settings_;
    const int client_quality = view.options.jpeg_quality;
    if (!view.governor) {
      view.governor.emplace(1000.0 / *settings_.target_fps, make_quality_ladder(settings_),
                            client_quality != 0 ? std::vector<JpegLevel>{{client_quality}}
                                                : make_jpeg_ladder(settings_.jpeg_quality));
    }
    return chosen_settings(view);
  }

  RendererSettings chosen_settings(const ViewState& view) const {
    if (!view.governor) return settings_;
    return with_quality(settings_, view.governor->quality(), view.governor->jpeg_quality());
  }

  passes::RenderView make_render_view(const ViewState& view, const FrameInput& input,
                                      const RendererSettings& settings,
                                      passes::EnvironmentLights lights) const {
    passes::RenderView render_view{
        .camera = view.options.camera,
        .ideal = passes::scaled_camera(view.ideal, static_cast<double>(settings.render_scale)),
        .scene = scene::anchor_scene(scene_, input.poses),
        .lights = std::move(lights),
        .samples_per_side = static_cast<int>(std::lround(std::sqrt(settings.samples_per_pixel))),
        .progress = input.progress,
    };
    const auto& punctual = render_view.scene.punctual_lights;
    render_view.lights.insert(render_view.lights.end(), punctual.begin(), punctual.end());
    return render_view;
  }

  // Not for frames with buffers, provenance or logged rays, which are not kept, nor with
  // refinement, which looks for edges in the camera's colors.
  void begin_still(ViewState& view, const RendererSettings& settings,
                   const passes::RenderView& render_view, bool keep_buffers) const {
    const bool refines = settings.adaptive_threshold || settings.trace_shadow_edges;
    if (!settings.reuse_still_frames || refines || keep_buffers || view.options.keep_provenance ||
        settings.ray_log != nullptr) {
      view.still.forget();
      return;
    }
    view.still.begin({render_view.scene, render_view.lights, surroundings_of(view).number,
                      render_view.samples_per_side, settings.render_scale, settings.trace});
  }

  // Requests the client's output from the graph; everything else follows by demand.
  static FrameOutput take_output(graph::FrameGraph& graph, const FramePasses& frame,
                                 const ViewState& view, const FrameInput& input) {
    FrameOutput output;
    const auto* jpeg = std::get_if<Bytes>(&input.image);
    if (jpeg != nullptr) {
      const passes::EncodedImage* encoded = graph.realise(frame.encoded);
      output.unchanged = encoded == nullptr;
      output.jpeg = encoded != nullptr ? encoded->jpeg : *jpeg;
    }
    if (view.options.keep_pixels) {
      const passes::Composite* composite = graph.realise(frame.composite);
      output.unchanged = composite == nullptr;
      output.pixels =
          composite != nullptr ? composite->pixels : graph.realise(frame.camera_image)->pixels;
    }
    return output;
  }

  RendererSettings settings_;
  scene::Scene scene_;  // without its environment
  std::uint64_t made_surroundings_ = 0;
  std::shared_ptr<Surroundings> surroundings_;  // of views without their own
  scene::SceneFeatures features_;
  std::vector<scene::Bounds> mesh_bounds_;  // by Scene::meshes
  std::optional<trace::EmbreeScene> embree_;
  std::optional<Raster> raster_;
  tbb::task_arena arena_;
  std::thread::id owner_;
  std::string last_graph_;
};

FrameRenderer::FrameRenderer(scene::Scene scene, const RendererSettings& settings)
    : impl_(std::make_unique<Impl>(std::move(scene), settings)) {}

FrameRenderer::~FrameRenderer() = default;

FrameOutput FrameRenderer::render(ViewState& view, const FrameInput& input, FrameBuffers* buffers) {
  return impl_->render(view, input, buffers);
}

void FrameRenderer::set_environment(scene::Environment environment) {
  impl_->set_environment(std::move(environment));
}

void FrameRenderer::set_own_environment(ViewState& view, scene::Environment environment) {
  impl_->set_own_environment(view, std::move(environment));
}

void FrameRenderer::free_targets() {
  impl_->free_targets();
}

void FrameRenderer::make_current() {
  impl_->make_current();
}

std::string FrameRenderer::hardware() const {
  return impl_->hardware();
}
const scene::Scene& FrameRenderer::scene() const {
  return impl_->scene();
}
const std::string& FrameRenderer::last_graph() const {
  return impl_->last_graph();
}

}  // namespace amalgam::frame
