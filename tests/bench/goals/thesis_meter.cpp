#include "bench/goals/thesis_meter.h"

#include <algorithm>
#include <cmath>

#include "bench/picture_error.h"
#include "bench/progress.h"
#include "bench/render_rig.h"
#include "frame/scene_variant.h"

namespace amalgam::bench {
namespace {

// Errors are taken at this width, with the row's proportions: a reference of 16 samples a pixel at
// full size would take minutes. The smaller picture's pixels are larger, so its edges weigh more:
// the figure is an upper one.
constexpr int kErrorWidth = 320;

constexpr int kReferenceSamples = 16;
constexpr int kReferenceDepth = 64;
// Not 0: within glass each ray makes two, and without a cut-off there are 2^depth.
constexpr float kReferenceCutoff = 1e-4f;

frame::RendererMode mode_for(ThesisMethod method) {
  switch (method) {
    case ThesisMethod::RayTracer:
      return frame::RendererMode::Raytrace;
    case ThesisMethod::DiffuseObjects:
      return frame::RendererMode::Diffuse;
    case ThesisMethod::OurMethod:
    case ThesisMethod::Rasterizer:
    case ThesisMethod::RasterizerSecondOrder:
      break;
  }
  return frame::RendererMode::Hybrid;
}

frame::RendererSettings settings_for(ThesisMethod method, const std::string& samples) {
  frame::RendererSettings settings = default_settings();
  settings.mode = mode_for(method);
  frame::parse_samples(samples, settings);
  return settings;
}

BenchCase load(const BenchScenes& scenes, ThesisScene scene, int width, int height) {
  switch (scene) {
    case ThesisScene::GlassBunny:
      return scenes.glass_bunny(width, height);
    case ThesisScene::MirrorBunny:
      return scenes.mirror_bunny(width, height);
    case ThesisScene::Complex:
      break;
  }
  return scenes.complex(width, height);
}

// What rows share if they are the same picture for us.
std::string key_of(const ThesisRow& row) {
  return std::string(to_string(row.scene)) + " " + std::to_string(row.width) + "x" +
         std::to_string(row.height) + " mode " +
         std::to_string(static_cast<int>(mode_for(row.method)));
}

BenchCase error_case(const BenchScenes& scenes, const ThesisRow& row) {
  return load(scenes, row.scene, kErrorWidth, kErrorWidth * row.height / row.width);
}

// Fixed, or two renderers would meter a little differently.
float metered_exposure(const BenchCase& bench_case) {
  return RenderRig(bench_case, default_settings()).render().statistics.exposure.y;
}

common::ImageRgb8 render_pixels(const BenchCase& bench_case,
                                const frame::RendererSettings& settings) {
  return RenderRig(bench_case, settings, {.keep_pixels = true}).render().pixels;
}

common::ImageRgb8 render_reference(BenchCase bench_case, ThesisMethod method, float exposure) {
  bench_case.scene = frame::scene_variant(std::move(bench_case.scene), mode_for(method));
  frame::RendererSettings settings = default_settings();
  settings.mode = frame::RendererMode::Raytrace;
  settings.samples_per_pixel = kReferenceSamples;
  settings.exposure = exposure;
  settings.trace.max_depth = kReferenceDepth;
  settings.trace.importance_cutoff = kReferenceCutoff;
  return render_pixels(bench_case, settings);
}

// Nothing if the frame is not reused, however long nothing moves.
std::optional<double> still_frames_per_second(const BenchCase& bench_case,
                                              frame::RendererSettings settings, double seconds) {
  settings.reuse_still_frames = true;
  RenderRig rig(bench_case, settings);
  rig.render();  // the second equal frame is kept; the rig made the first
  const frame::FrameOutput third = rig.render();
  const auto& passes = third.statistics.passes;
  const bool masked = std::any_of(passes.begin(), passes.end(), [](const auto& pass) {
    return (pass.name == "mask" || pass.name == "trace") && pass.ran;
  });
  if (masked) return std::nullopt;
  return 1000.0 / median_frame_milliseconds(rig, seconds);
}

}  // namespace

double ThesisMeter::error(const ThesisRow& row, const std::string& samples) {
  const BenchCase small = error_case(scenes_, row);
  frame::RendererSettings settings = settings_for(row.method, samples);
  settings.exposure = metered_exposure(small);
  auto found = references_.find(key_of(row));
  if (found == references_.end()) {
    say_progress("    reference for the error of " + key_of(row));
    found =
        references_.emplace(key_of(row), render_reference(small, row.method, *settings.exposure))
            .first;
  }
  return mean_difference(render_pixels(small, settings), found->second);
}

const ThesisMeter::Figures& ThesisMeter::figures(const ThesisRow& row, const std::string& samples) {
  const std::string key = key_of(row) + " samples " + samples;
  const auto found = figures_.find(key);
  if (found != figures_.end()) return found->second;
  say_progress("  Table 6.1, " + key);
  const BenchCase full = load(scenes_, row.scene, row.width, row.height);
  Figures figures;
  {
    RenderRig rig(full, settings_for(row.method, samples));
    figures.frames_per_second = 1000.0 / median_frame_milliseconds(rig, seconds_);
  }
  figures.still_frames_per_second =
      still_frames_per_second(full, settings_for(row.method, samples), seconds_);
  figures.error = error(row, samples);
  return figures_.emplace(key, figures).first->second;
}

ThesisResult ThesisMeter::measure(const ThesisRow& row) {
  const Figures& fixed = figures(row, std::to_string(row.samples));
  ThesisResult result{
      .row = row, .frames_per_second = fixed.frames_per_second, .error = fixed.error};
  result.still_frames_per_second = fixed.still_frames_per_second;
  if (row.samples == 1) return result;
  const Figures& adaptive = figures(row, "adaptive");
  result.adaptive_error = adaptive.error;
  if (adaptive.error > fixed.error || adaptive.frames_per_second < fixed.frames_per_second) {
    return result;
  }
  result.adaptive = true;
  result.error = adaptive.error;
  result.frames_per_second = adaptive.frames_per_second;
  return result;
}

}  // namespace amalgam::bench
