// Results that a view's frames share while nothing moves: all but the camera's colors and the
// exposure. On a tripod, a frame then only looks these up.
//
// Kept from the second of two equal frames on, so that a moving camera has no cost. Dropped with
// the first frame that differs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "passes/image/look_up.h"
#include "passes/image/meter_grid.h"
#include "passes/raster/mask.h"
#include "passes/raster/raster_context.h"
#include "scene/anchored_scene.h"
#include "trace/trace_request.h"

namespace amalgam::graph {
class FrameGraph;
}

namespace amalgam::frame {

struct FramePasses;

// Everything that the kept results depend on and that may change during the life of a view.
struct StillKey {
  scene::AnchoredScene scene;
  std::vector<scene::Light> lights;
  std::uint64_t environment = 0;  // Surroundings::number
  int samples_per_side = 1;
  float render_scale = 1.0f;
  trace::TraceSettings trace;

  bool operator==(const StillKey&) const = default;
};

// A pass's result, or why there is none.
template <typename T>
struct Kept {
  std::optional<T> value;
  std::string reason{};
};

struct StillFrame {
  Kept<passes::SampleCounts> counts;
  Kept<passes::MeterGrid> meter_grid;
  Kept<passes::ShadedTiles> shaded;  // only tiles in which something virtual shows
  Kept<passes::KeptPaths> paths;
};

// Gathers the results of a frame that equal frames after it may reuse. graph: already evaluated.
// Nothing if the results take more than StillView::kMostBytes.
std::optional<StillFrame> collect_still(const graph::FrameGraph& graph, const FramePasses& frame,
                                        const passes::RenderView& view);

class StillView {
 public:
  // The most that a view keeps.
  static constexpr std::size_t kMostBytes = std::size_t{64} << 20;

  // Begins a frame that may use and keep results. Drops kept ones if the key differs.
  void begin(StillKey key);
  // Begins a frame that may not. Drops everything.
  void forget();

  // The results kept for the frame that has begun; null if there are none.
  const StillFrame* frame() const { return frame_ ? &*frame_ : nullptr; }
  // Whether the frame that has begun should be kept when it is done.
  bool wants_frame() const { return seen_before_ && !frame_ && !too_large_; }
  void keep(StillFrame frame) { frame_ = std::move(frame); }
  // The results take too much memory: keeps none for this key.
  void give_up() { too_large_ = true; }

 private:
  std::optional<StillKey> key_;
  std::optional<StillFrame> frame_;
  bool seen_before_ = false, too_large_ = false;
};

}  // namespace amalgam::frame
