#include "frame/collect_still.h"

namespace amalgam::frame {

std::optional<StillFrame> collect_still(const graph::FrameGraph& graph, const FramePasses& frame,
                                        const passes::RenderView& view) {
  StillFrame still;
  std::size_t bytes = 0;
  if (const auto* counts = graph.peek(frame.mask.counts)) still.counts = *counts;

  still.meter_grid.reason = graph.reason_absent(frame.meter_grid);
  if (const auto* grid = graph.peek(frame.meter_grid)) still.meter_grid.value = *grid;

  still.shaded.reason = graph.reason_absent(frame.effect);
  if (const auto* effect = graph.peek(frame.effect)) {
    still.shaded.value = passes::copy_what_shows(*effect->tiles, view);
    bytes += still.shaded.value->bytes();
  }

  still.paths.reason = graph.reason_absent(frame.traced);
  if (const auto* traced = graph.peek(frame.traced)) {
    if (traced->paths == nullptr) return std::nullopt;
    still.paths.value = traced->paths;
    bytes += traced->paths->bytes();
  }
  if (bytes > StillView::kMostBytes) return std::nullopt;
  return still;
}

}  // namespace amalgam::frame
