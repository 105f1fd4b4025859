// All settings of the renderer that an operator may change, with their defaults.
#pragma once

#include <optional>
#include <string_view>

#include "passes/image/exposure.h"
#include "scene/light/env_lights.h"
#include "scene/light/real_surfaces.h"
#include "trace/tracer.h"

namespace amalgam::frame {

enum class RendererMode {
  Hybrid,    // rasterise diffuse surfaces, trace specular ones: the method
  Raytrace,  // trace every pixel; needs no OpenGL
  Raster,    // specular objects are left out
  Diffuse,   // specular objects are painted diffuse (Table 6.1, note 3)
};

// Throws std::invalid_argument naming the choices.
RendererMode parse_renderer_mode(std::string_view text);
const char* renderer_mode_name(RendererMode mode);

inline constexpr float kDefaultAdaptiveThreshold = 0.03f;

struct RendererSettings {
  RendererMode mode = RendererMode::Hybrid;
  int samples_per_pixel = 1;  // 1, 4, 9 or 16
  // Set: one sample a pixel, and nine where neighbours differ by more than this (display-linear).
  std::optional<float> adaptive_threshold;
  // Hybrid: traces pixels at shadow edges again, because a shadow map is exact only to a texel.
  // Needs an Embree scene, and rays for those pixels, even if nothing is specular.
  bool trace_shadow_edges = false;
  // Shades diffuse surfaces only in tiles where something virtual may show. Off for comparisons:
  // the picture is the same to the bit.
  bool leave_out_tiles = true;
  // While nothing moves, only looks up the camera's new colors. Off to measure the cost of a moving
  // camera: the picture is the same to the bit.
  bool reuse_still_frames = true;
  trace::TraceSettings trace;
  scene::EnvLightOptions env_lights;
  // None: metered on the markers' paper and on the real surfaces in view.
  std::optional<float> exposure;
  passes::ExposureCard exposure_card = passes::ExposureCard::Paper;
  // The metered exposure has a factor for each channel, so that a warm environment does not tint
  // objects in a white-balanced camera image.
  bool white_balance = true;
  // The camera's response. None: chosen by the markers' contrast; Reinhard with a fixed exposure.
  std::optional<scene::ToneCurve> tone_curve;
  scene::RealSurfaces real_surfaces = scene::RealSurfaces::Ratio;
  trace::RayLog* ray_log = nullptr;  // for measuring: collects the rays of the tracer
  int threads = 0;                   // 0: one for each core that the process may use
  int jpeg_quality = 90;             // 1..100, for clients that want the default
  // (0, 1]: rendered pixels for each of the camera's, on each axis. The layers are scaled up; the
  // camera image keeps its resolution.
  float render_scale = 1.0f;
  // Frames a second. Set: the governor lowers each view's quality below these settings where a
  // frame would take longer (frame/governor.h).
  std::optional<double> target_fps;
  // Whether target_fps may visibly lower quality: render scale, and a depth below 8. Without it
  // pictures keep a structural similarity of about .98.
  bool coarse_allowed = false;
};

// "1", "4", "9", "16", "adaptive" or "adaptive:THRESHOLD", threshold in (0, 1]. Throws
// std::invalid_argument.
void parse_samples(std::string_view text, RendererSettings& settings);

// Throws std::invalid_argument for settings that cannot be rendered with.
void check_settings(const RendererSettings& settings);

}  // namespace amalgam::frame
