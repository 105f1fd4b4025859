#include "report/scene_meter.h"

#include <cstdio>

#include "common/build_info.h"
#include "core/timings.h"
#include "frame/settings_options.h"
#include "report/composites.h"
#include "report/host.h"
#include "report/report_scene.h"

namespace amalgam::report {
namespace {

std::string stages_text(const core::StageTimes& stages) {
  std::string text;
  for (const core::StageTime& time : stages) {
    char number[32];
    std::snprintf(number, sizeof number, "%.3f", time.milliseconds);
    text += (text.empty() ? "" : "; ") + time.stage + " " + number;
  }
  return text;
}

void set_knobs(RunRow& row, const SweepPoint& point) {
  const frame::RendererSettings& settings = point.settings;
  row.sweep = point.sweep;
  row.point = point.label;
  row.value = point.value;
  row.threads = static_cast<std::uint64_t>(settings.threads);
  row.renderer = frame::renderer_mode_name(settings.mode);
  row.samples = static_cast<std::uint64_t>(settings.samples_per_pixel);
  if (settings.adaptive_threshold) {
    row.adaptive_threshold = static_cast<double>(*settings.adaptive_threshold);
  }
  row.max_depth = static_cast<std::uint64_t>(settings.trace.max_depth);
  row.importance_cutoff = static_cast<double>(settings.trace.importance_cutoff);
  row.fresnel = settings.trace.fresnel == trace::FresnelModel::Exact ? "exact" : "schlick";
  row.env_lights = scene::to_string(settings.env_lights);
  row.shadow_edges = settings.trace_shadow_edges ? "traced" : "map";
  row.render_scale = static_cast<double>(settings.render_scale);
  row.exposure = static_cast<double>(settings.exposure.value_or(1.0f));
  row.jpeg_quality = static_cast<std::uint64_t>(point.jpeg_quality);
  row.reference = to_string(point.reference);
}

// The same for settings that render alike.
std::string settings_text(const frame::RendererSettings& settings) {
  std::string text = frame::settings_without_options(settings);
  for (const std::string& word : frame::settings_options(settings)) text += " " + word;
  return text;
}

void set_costs(RunRow& row, const frame::FrameOutput& output) {
  const core::RayCounts& rays = output.statistics.rays;
  row.stages_ms = stages_text(output.statistics.stages);
  row.rays_primary = rays.primary;
  row.rays_reflection = rays.reflection;
  row.rays_refraction = rays.refraction;
  row.rays_shadow = rays.shadow;
  row.rays_lookup = rays.lookup;
  row.output_bytes = output.jpeg.size();
}

}  // namespace

SceneMeter::SceneMeter(const ReportScene& scene, bench::BenchCase bench_case,
                       ReferenceStore& references, double exposure, const RunPlan& plan)
    : scene_name_(scene.name),
      move_(scene.move),
      case_(std::move(bench_case)),
      references_(references),
      exposure_(exposure),
      plan_(plan) {}

RunRow SceneMeter::describe(const SweepPoint& point, int run) const {
  static const std::string commit = source_commit(), processor = processor_name();
  RunRow row;
  row.commit = commit;
  row.host_cpu = processor;
  // What the compiler may use. Embree chooses its own: a renderer that is told which would say so
  // here.
  row.isa = common::instruction_set();
  row.scene = scene_name_;
  row.width = static_cast<std::uint64_t>(case_.camera.width);
  row.height = static_cast<std::uint64_t>(case_.camera.height);
  set_knobs(row, point);
  row.run = static_cast<std::uint64_t>(run);
  const int index = run * plan_.places / plan_.runs;
  row.offset = static_cast<std::uint64_t>(index);
  const glm::dvec2 offset = sub_pixel_offset(index);
  row.offset_x = offset.x;
  row.offset_y = offset.y;
  return row;
}

RunRow SceneMeter::measure(const SweepPoint& point, int run) {
  RunRow row = describe(point, run);
  const auto index = static_cast<int>(row.offset);
  bench::RenderRig& rendering = renderer(point, index);
  const Errors& measured = errors(point, index);

  const double cpu = process_cpu_milliseconds();
  const core::Stopwatch stopwatch;
  const frame::FrameOutput output = rendering.render(place(index).input);
  row.time_ms = stopwatch.milliseconds();
  row.cpu_ms = process_cpu_milliseconds() - cpu;
  set_costs(row, output);

  const PictureFigures& figures = measured.figures;
  row.mae = figures.mae;
  row.mse = figures.mse;
  row.mrse = figures.mrse;
  row.ssim = figures.ssim;
  row.psnr = figures.psnr;
  row.maximum = figures.maximum;
  row.nonfinite = figures.nonfinite + output.statistics.nonfinite;
  row.truncation_bound_mean = output.statistics.truncation_bound.mean;
  row.truncation_bound_worst = output.statistics.truncation_bound.worst;
  row.limit_mae = measured.limit_mae;
  row.floor_mae = measured.floor_mae;
  row.jpeg_mae = measured.jpeg_mae;
  return row;
}

SceneMeter::Pictures SceneMeter::pictures(const SweepPoint& point) {
  const bench::BenchCase& at = place(0);
  return {render_composites(renderer(point, 0), at.input, camera_image_of(at.input),
                            point.settings.render_scale)
              .before_jpeg,
          references_.composite(at, exposure_, point.reference)};
}

const bench::BenchCase& SceneMeter::place(int index) {
  const auto found = places_.find(index);
  if (found != places_.end()) return found->second;
  return places_.emplace(index, move_(case_, sub_pixel_offset(index))).first->second;
}

bench::RenderRig& SceneMeter::renderer(const SweepPoint& point, int index) {
  const std::string settings = settings_text(point.settings);
  const std::string view = std::to_string(index) + " quality " + std::to_string(point.jpeg_quality);
  Rig& rig = default_.renderer == nullptr || default_.settings == settings ? default_ : other_;
  const bench::RigOptions options{.jpeg_quality = point.jpeg_quality};
  if (rig.settings != settings || rig.renderer == nullptr) {
    rig = {};
    rig = {settings, view,
           std::make_unique<bench::RenderRig>(place(index), point.settings, options)};
  }
  if (rig.view != view) {
    rig.renderer->look_through(place(index).camera, options);
    rig.view = view;
  }
  return *rig.renderer;
}

double SceneMeter::limit_error(const SweepPoint& point) {
  const bench::BenchCase& at = place(0);
  frame::RendererSettings settings = point.settings;
  settings.mode = frame::RendererMode::Raytrace;
  bench::RenderRig traced(at, settings);
  const Composites composites =
      render_composites(traced, at.input, camera_image_of(at.input), settings.render_scale);
  return mean_absolute_error(composites.before_jpeg,
                             references_.composite(at, exposure_, *point.limit));
}

const SceneMeter::Errors& SceneMeter::errors(const SweepPoint& point, int index) {
  const std::string name = point.sweep + " " + point.label;
  if (name != point_) errors_.clear();
  point_ = name;
  const auto found = errors_.find(index);
  if (found != errors_.end()) return found->second;
  const bench::BenchCase& at = place(index);
  const Composites composites = render_composites(
      renderer(point, index), at.input, camera_image_of(at.input), point.settings.render_scale);
  Errors result;
  result.figures = picture_figures(composites.before_jpeg,
                                   references_.composite(at, exposure_, point.reference));
  result.jpeg_mae = mean_absolute_error(composites.after_jpeg, composites.before_jpeg);
  // The law of a knob shows at one place as well as at many, and floors are alike.
  result.floor_mae = references_.floor(place(0), exposure_, point.reference);
  if (point.limit && index == 0) result.limit_mae = limit_error(point);
  return errors_.emplace(index, result).first->second;
}

}  // namespace amalgam::report
