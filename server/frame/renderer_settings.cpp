#include "frame/renderer_settings.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace amalgam::frame {

namespace {

struct NamedMode {
  RendererMode mode;
  const char* name;
};
constexpr NamedMode kModes[] = {{RendererMode::Hybrid, "hybrid"},
                                {RendererMode::Raytrace, "raytrace"},
                                {RendererMode::Raster, "raster"},
                                {RendererMode::Diffuse, "diffuse"}};

}  // namespace

RendererMode parse_renderer_mode(std::string_view text) {
  for (const auto& [mode, name] : kModes) {
    if (text == name) return mode;
  }
  throw std::invalid_argument("renderer '" + std::string(text) +
                              "' is none of hybrid, raytrace, raster, diffuse");
}

const char* renderer_mode_name(RendererMode mode) {
  for (const auto& [named, name] : kModes) {
    if (named == mode) return name;
  }
  return "";
}

void parse_samples(std::string_view text, RendererSettings& settings) {
  constexpr std::string_view kAdaptive = "adaptive";
  const auto refuse = [&] {
    throw std::invalid_argument("samples '" + std::string(text) +
                                "' is none of 1, 4, 9, 16, adaptive, adaptive:THRESHOLD (0 to 1)");
  };
  settings.adaptive_threshold.reset();
  if (text.starts_with(kAdaptive)) {
    settings.samples_per_pixel = 1;
    settings.adaptive_threshold = kDefaultAdaptiveThreshold;
    const std::string_view rest = text.substr(kAdaptive.size());
    if (rest.empty()) return;
    float threshold = 0.0f;
    const char* end = rest.data() + rest.size();
    if (rest.front() != ':') refuse();
    const auto parsed = std::from_chars(rest.data() + 1, end, threshold);
    if (parsed.ec != std::errc() || parsed.ptr != end || !(threshold > 0.0f && threshold <= 1.0f)) {
      refuse();
    }
    settings.adaptive_threshold = threshold;
    return;
  }
  int samples = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), samples);
  if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size()) refuse();
  if (samples != 1 && samples != 4 && samples != 9 && samples != 16) refuse();
  settings.samples_per_pixel = samples;
}

void check_settings(const RendererSettings& settings) {
  const int n = settings.samples_per_pixel;
  if (n != 1 && n != 4 && n != 9 && n != 16) {
    throw std::invalid_argument("samples per pixel must be 1, 4, 9 or 16, not " +
                                std::to_string(n));
  }
  if (settings.adaptive_threshold && (n != 1 || !(*settings.adaptive_threshold > 0.0f))) {
    throw std::invalid_argument(
        "adaptive sampling starts from one sample, with a positive threshold");
  }
  if (settings.trace.max_depth < 0 || settings.trace.max_depth > 10000) {
    throw std::invalid_argument("max depth must be within 0 and 10000");
  }
  if (!(settings.trace.importance_cutoff >= 0.0f && settings.trace.importance_cutoff < 1.0f)) {
    throw std::invalid_argument("importance cut-off must be at least 0 and below 1");
  }
  if (settings.exposure && !(*settings.exposure > 0.0f && std::isfinite(*settings.exposure))) {
    throw std::invalid_argument("exposure must be positive");
  }
  if (settings.threads < 0) throw std::invalid_argument("threads must not be negative");
  if (settings.jpeg_quality < 1 || settings.jpeg_quality > 100) {
    throw std::invalid_argument("JPEG quality must be within 1 and 100");
  }
  if (!(settings.render_scale > 0.0f && settings.render_scale <= 1.0f)) {
    throw std::invalid_argument("render scale must be above 0 and at most 1");
  }
  if (settings.target_fps && !(*settings.target_fps > 0.0 && *settings.target_fps <= 1000.0)) {
    throw std::invalid_argument("target frame rate must be above 0 and at most 1000");
  }
}

}  // namespace amalgam::frame
