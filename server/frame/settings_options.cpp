#include "frame/settings_options.h"

#include <array>
#include <charconv>

namespace amalgam::frame {
namespace {

template <typename Number>
std::string shortest(Number number) {
  std::array<char, 64> text;
  const auto written = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), written.ptr};
}

std::string samples_text(int samples_per_pixel, const std::optional<float>& adaptive_threshold) {
  if (!adaptive_threshold) return std::to_string(samples_per_pixel);
  return "adaptive:" + exact_text(*adaptive_threshold);
}

}  // namespace

std::string exact_text(float number) {
  return shortest(number);
}
std::string exact_text(double number) {
  return shortest(number);
}

std::vector<std::string> settings_options(const RendererSettings& settings) {
  namespace names = option_names;
  const RendererSettings defaults;
  // Names all members: a new one does not compile before it is handled here.
  const auto& [mode, samples_per_pixel, adaptive_threshold, trace_shadow_edges, leave_out_tiles,
               reuse_still_frames, trace, env_lights, exposure, exposure_card, white_balance,
               tone_curve, real_surfaces, ray_log, threads, jpeg_quality, render_scale, target_fps,
               coarse_allowed] = settings;
  const auto& [max_depth, importance_cutoff, fresnel] = trace;

  std::vector<std::string> words;
  const auto add = [&](bool differs, const char* name, const std::string& value) {
    if (differs) words.insert(words.end(), {name, value});
  };
  add(mode != defaults.mode, names::kRenderer, renderer_mode_name(mode));
  add(samples_per_pixel != defaults.samples_per_pixel || adaptive_threshold, names::kSamples,
      samples_text(samples_per_pixel, adaptive_threshold));
  add(trace_shadow_edges, names::kShadowEdges, "traced");
  add(max_depth != defaults.trace.max_depth, names::kMaxDepth, std::to_string(max_depth));
  add(importance_cutoff != defaults.trace.importance_cutoff, names::kImportanceCutoff,
      exact_text(importance_cutoff));
  add(fresnel != defaults.trace.fresnel, names::kFresnel, "exact");
  add(env_lights != defaults.env_lights, names::kEnvLights, scene::to_string(env_lights));
  add(exposure.has_value(), names::kExposure, exact_text(exposure.value_or(1.0f)));
  add(exposure_card != defaults.exposure_card, names::kMeter,
      passes::exposure_card_name(exposure_card));
  add(white_balance != defaults.white_balance, names::kWhiteBalance,
      white_balance ? "auto" : "off");
  if (tone_curve) add(true, names::kToneMap, scene::tone_curve_name(*tone_curve));
  add(real_surfaces != defaults.real_surfaces, names::kRealSurfaces,
      scene::real_surfaces_name(real_surfaces));
  add(render_scale != defaults.render_scale, names::kRenderScale, exact_text(render_scale));
  add(target_fps.has_value(), names::kTargetFps, exact_text(target_fps.value_or(0.0)));
  if (coarse_allowed) words.emplace_back(names::kCoarse);
  add(threads != defaults.threads, names::kThreads, std::to_string(threads));
  // These have no options that all programs share: see settings_without_options(). The option
  // --still of amalgam-render reuses frames; ReplayedFrame::repeat asks for it.
  static_cast<void>(leave_out_tiles);
  static_cast<void>(reuse_still_frames);
  static_cast<void>(ray_log);
  static_cast<void>(jpeg_quality);
  return words;
}

std::string settings_without_options(const RendererSettings& settings) {
  const RendererSettings defaults;
  std::string text;
  const auto add = [&](bool differs, const std::string& what) {
    if (differs) text += (text.empty() ? "" : ", ") + what;
  };
  add(!settings.leave_out_tiles, "leave_out_tiles is false");
  add(settings.ray_log != nullptr, "rays are logged");
  add(settings.jpeg_quality != defaults.jpeg_quality,
      "jpeg_quality is " + std::to_string(settings.jpeg_quality));
  return text;
}

}  // namespace amalgam::frame
