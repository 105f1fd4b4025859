// All knobs of the renderer that an operator may turn, with their defaults.
#pragma once

#include <optional>
#include <string_view>

#include "scene/light/env_lights.h"
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
  // Hybrid: pixels at edges of shadows are traced again, because a shadow map is exact only to a
  // texel. Costs an Embree scene and rays for those pixels, even in scenes without anything
  // specular.
  bool trace_shadow_edges = false;
  // Diffuse surfaces are shaded only in tiles where something virtual may show. Off for
  // comparisons: the picture is the same to the bit.
  bool leave_out_tiles = true;
  // While nothing moves, only the camera's colors are looked up anew. Off for measuring what a
  // moving camera costs: the picture is the same to the bit.
  bool reuse_still_frames = true;
  trace::TraceSettings trace;
  scene::EnvLightOptions env_lights;
  std::optional<float> exposure;     // none: metered on the real surfaces in view
  trace::RayLog* ray_log = nullptr;  // for measuring: collects what the tracer asks of Embree
  int threads = 0;                   // for rendering; 0: all cores that the process may use
  int jpeg_quality = 90;             // 1..100, where a client wants the default
  // (0, 1]: virtual things are rendered in so many pixels for each of the camera's, on each axis,
  // and scaled up. The camera image keeps all of its own.
  float render_scale = 1.0f;
  // Frames a second. Set: each view's quality is lowered below these settings, but never raised
  // above them, so that a frame takes no longer (frame/governor.h).
  std::optional<double> target_fps;
  // Whether target_fps may cost what is plainly seen: pixels, and all but a few bounces. Without
  // it, quality stays where pictures keep a structural similarity of about .98.
  bool coarse_allowed = false;
};

// "1", "4", "9", "16", "adaptive" or "adaptive:THRESHOLD", threshold in (0, 1]. Throws
// std::invalid_argument.
void parse_samples(std::string_view text, RendererSettings& settings);

// Throws std::invalid_argument for what cannot be rendered with.
void check_settings(const RendererSettings& settings);

}  // namespace amalgam::frame
