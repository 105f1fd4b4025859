#include "frame/renderer_settings.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace amalgam::frame {

RendererMode parse_renderer_mode(std::string_view text) {
  if (text == "hybrid") return RendererMode::Hybrid;
  if (text == "raytrace") return RendererMode::Raytrace;
  if (text == "raster") return RendererMode::Raster;
  if (text == "diffuse") return RendererMode::Diffuse;
  throw std::invalid_argument("renderer '" + std::string(text) +
                              "' is none of hybrid, raytrace, raster, diffuse");
}

void check_settings(const RendererSettings& settings) {
  const int n = settings.samples_per_pixel;
  if (n != 1 && n != 4 && n != 9 && n != 16) {
    throw std::invalid_argument("samples per pixel must be 1, 4, 9 or 16, not " +
                                std::to_string(n));
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
}

}  // namespace amalgam::frame
