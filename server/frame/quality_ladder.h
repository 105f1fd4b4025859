// The levels of quality of a governed view, from the operator's settings down. The order is by
// visible harm for each millisecond saved.
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
  // Estimated costs of tracing and rasterising the same view, as shares of level 0's. The governor
  // corrects them by measurement.
  double trace_cost = 1.0, raster_cost = 1.0;
  bool operator==(const QualityLevel&) const = default;
};

// The first level is the settings themselves; no level exceeds them in anything. Deterministic.
std::vector<QualityLevel> make_quality_ladder(const RendererSettings& settings);

// For clients that leave the JPEG quality to the server: the settings' own first.
struct JpegLevel {
  int quality = 0;
  double cost = 1.0;  // of encoding, as a share of the first level's
};
std::vector<JpegLevel> make_jpeg_ladder(int quality);

// The settings with their quality replaced by the level's.
RendererSettings with_quality(RendererSettings settings, const QualityLevel& level,
                              int jpeg_quality);

}  // namespace amalgam::frame
