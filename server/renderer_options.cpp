#include "server/renderer_options.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "common/parse_command_line.h"
#include "frame/settings_options.h"
#include "gl/shader_interface.h"

namespace amalgam::tools {
namespace {

// An option that takes one of a few words; the first is the default.
void add_choice(CLI::App& app, const char* name, const std::vector<std::string>& choices,
                const std::function<void(const std::string&)>& choose, const std::string& help) {
  app.add_option_function<std::string>(name, choose, help)
      ->check(CLI::IsMember(choices))
      ->default_str(choices.front());
}

}  // namespace

void add_renderer_options(CLI::App& app, frame::RendererSettings& settings) {
  namespace names = frame::option_names;
  add_choice(
      app, names::kRenderer, {"hybrid", "raytrace", "raster", "diffuse"},
      [&settings](const std::string& text) { settings.mode = frame::parse_renderer_mode(text); },
      "hybrid (rasterise diffuse, trace specular), raytrace (trace all), raster (leave specular "
      "objects out) or diffuse (paint them diffuse)");
  app.add_option_function<std::string>(
         names::kSamples,
         [&settings](const std::string& text) {
           try {
             frame::parse_samples(text, settings);
           } catch (const std::invalid_argument& error) {
             throw CLI::ValidationError(names::kSamples, error.what());
           }
         },
         "samples a pixel: 1, 4, 9, 16, or adaptive[:THRESHOLD], which takes 9 only where "
         "neighbours "
         "differ by more than THRESHOLD (display-linear, default 0.03)")
      ->default_str("1");
  add_choice(
      app, names::kShadowEdges, {"map", "traced"},
      [&settings](const std::string& text) { settings.trace_shadow_edges = text == "traced"; },
      "edges of shadows on rasterised surfaces: map (as exact as a texel of the shadow map) or "
      "traced");
  app.add_option(
         names::kMaxDepth, settings.trace.max_depth,
         "specular surfaces that a ray may meet; one that is cut off takes the environment's "
         "color, as by --importance-cutoff")
      ->check(common::in_range(0, 10000))
      ->capture_default_str();
  app.add_option(names::kImportanceCutoff, settings.trace.importance_cutoff,
                 "share of a pixel [0, 1) below which a ray's branch ends")
      ->check(common::in_range(0.0, 0.999))
      ->capture_default_str();
  add_choice(
      app, names::kFresnel, {"schlick", "exact"},
      [&settings](const std::string& text) {
        settings.trace.fresnel =
            text == "exact" ? trace::FresnelModel::Exact : trace::FresnelModel::Schlick;
      },
      "reflectance of glass: schlick or exact");
  app.add_option_function<std::string>(
         names::kEnvLights,
         [&settings](const std::string& text) {
           settings.env_lights = scene::parse_env_light_options(text);
         },
         "lights made of the environment map: sectors (8) or median-cut:N, N up to " +
             std::to_string(scene::kMaxEnvLights) + " (" + std::to_string(gl::kMaxLights) +
             " if rasterising)")
      ->default_str("sectors");
  app.add_option_function<float>(
         names::kExposure, [&settings](const float& exposure) { settings.exposure = exposure; },
         "fixed exposure (factor on scene-linear light, the same for all channels); without it, "
         "metered")
      ->check(CLI::Validator(
          [](const std::string& text) {
            float value = 0.0f;
            const bool good = CLI::detail::lexical_cast(text, value) && value > 0.0f;
            return good ? std::string() : "'" + text + "' is not a number above 0";
          },
          ""));
  add_choice(
      app, names::kMeter, {"paper", "grey"},
      [&settings](const std::string& text) {
        settings.exposure_card = passes::parse_exposure_card(text);
      },
      "what the exposure is metered on: paper (the markers' paper, or the real surfaces where "
      "that is not seen) or grey (the real surfaces, as bright as they are modelled)");
  add_choice(
      app, names::kWhiteBalance, {"auto", "off"},
      [&settings](const std::string& text) { settings.white_balance = text == "auto"; },
      "auto: the metered exposure has a factor for each channel, by the markers' paper; off: "
      "one for all");
  add_choice(
      app, names::kToneMap, {"auto", "reinhard", "linear"},
      [&settings](const std::string& text) {
        settings.tone_curve.reset();
        if (text != "auto") settings.tone_curve = scene::parse_tone_curve(text);
      },
      "the camera's response: reinhard (L / (1 + L)), linear (clipped at 1), or auto: by the "
      "markers' contrast, reinhard where it cannot be measured or the exposure is fixed");
  add_choice(
      app, names::kRealSurfaces, {"ratio", "difference"},
      [&settings](const std::string& text) {
        settings.real_surfaces = scene::parse_real_surfaces(text);
      },
      "what virtual objects do to real surfaces: ratio (the camera's color times modelled light "
      "with / without them) or difference (plus the modelled difference, eq. 4.5)");
  app.add_option(names::kRenderScale, settings.render_scale,
                 "(0, 1]: pixels that virtual things are rendered in for each of the camera's, on "
                 "each axis; the camera image keeps all of its own")
      ->check(common::in_range(0.01, 1.0))
      ->capture_default_str();
  app.add_option(names::kTargetFps, settings.target_fps,
                 "frames a second: a frame's quality is lowered until it takes no longer; without "
                 "it, quality is as the other options say")
      ->check(common::in_range(0.1, 1000.0));
  app.add_flag(names::kCoarse, settings.coarse_allowed,
               "let --target-fps lower what is plainly seen too: pixels (as --render-scale) and "
               "depth below 8");
  app.add_option(names::kThreads, settings.threads,
                 "threads for rendering; 0: one for each core that this process may use, which "
                 "affinity and a container's CPU quota may lessen")
      ->check(common::in_range(0, 4096))
      ->capture_default_str();
}

std::string default_scene_path() {
  namespace fs = std::filesystem;
  std::error_code ignored;  // without /proc the path is wrong, and loading says so
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  const fs::path beside = program / "../../deploy/scenes/complex.gltf";
  const fs::path installed = program / "../share/amalgam/scenes/complex.gltf";
  return (fs::exists(installed, ignored) ? installed : beside).lexically_normal().string();
}

}  // namespace amalgam::tools
