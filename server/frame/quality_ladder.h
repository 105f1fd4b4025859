// What a governed view may be rendered with: levels from the operator's own settings down, ordered
// by the harm that one sees for each millisecond saved.
#pragma once

#include <optional>
#include <vector>

#include "frame/renderer_settings.h"

namespace amalgam::frame {

struct QualityLevel {
  int samples_per_pixel = 1;                // 1, 4, 9 or 16
  std::optional<float> adaptive_threshold;  // as RendererSettings
  bool trace_shadow_edges = false;
  int max_depth = 0;
  float importance_cutoff = 0.0f;
  float render_scale = 1.0f;
  // What tracing and rasterising the same things is thought to take, as a share of level 0's. First
  // guesses: the governor corrects them by what it measures.
  double trace_cost = 1.0, raster_cost = 1.0;
  bool operator==(const QualityLevel&) const = default;
};

// The first level is the settings themselves, and none is above them in anything. Always the same
// for the same settings.
std::vector<QualityLevel> make_quality_ladder(const RendererSettings& settings);

// 1 to 100, the settings' own first, for clients that leave it to the server.
struct JpegLevel {
  int quality = 0;
  double cost = 1.0;  // of encoding, as a share of the first level's
};
std::vector<JpegLevel> make_jpeg_ladder(int quality);

// The settings with a level's quality in place of their own.
RendererSettings with_quality(RendererSettings settings, const QualityLevel& level,
                              int jpeg_quality);

}  // namespace amalgam::frame
