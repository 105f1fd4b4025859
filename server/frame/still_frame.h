// What one view's frames have in common while nothing moves: all but the camera's colors and the
// exposure. A camera on a tripod then pays only for looking these up.
//
// Kept from the second of two equal frames on, so that a moving camera pays nothing for it, and
// dropped with the first frame that differs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "passes/image/exposure_meter.h"
#include "passes/image/look_up.h"
#include "passes/raster/mask.h"
#include "passes/raster/raster_context.h"
#include "scene/anchored_scene.h"
#include "trace/trace_request.h"

namespace amalgam::graph {
class FrameGraph;
}

namespace amalgam::frame {

struct FramePasses;

// All that the kept results depend on. Everything else is fixed for the life of a view.
struct StillKey {
  scene::AnchoredScene scene;
  std::vector<scene::Light> lights;
  std::uint64_t environment = 0;  // number of changes so far
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

// What a frame leaves for equal ones after it. Of a graph that has been evaluated. Nothing if it
// would take more than StillView::kMostBytes.
std::optional<StillFrame> collect_still(const graph::FrameGraph& graph, const FramePasses& frame,
                                        const passes::RenderView& view);

class StillView {
 public:
  // A view does not keep more than this.
  static constexpr std::size_t kMostBytes = std::size_t{64} << 20;

  // A frame that may use and leave something. Drops what does not hold for it.
  void begin(StillKey key);
  // A frame that may not: drops everything.
  void forget();

  // What holds for the frame that has begun; null if nothing does.
  const StillFrame* frame() const { return frame_ ? &*frame_ : nullptr; }
  // Whether the frame that has begun should be kept when it is done.
  bool wants_frame() const { return seen_before_ && !frame_ && !too_large_; }
  void keep(StillFrame frame) { frame_ = std::move(frame); }
  // Frames like this one take too much memory.
  void give_up() { too_large_ = true; }

 private:
  std::optional<StillKey> key_;
  std::optional<StillFrame> frame_;
  bool seen_before_ = false, too_large_ = false;
};

}  // namespace amalgam::frame
