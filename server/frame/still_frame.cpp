#include "frame/still_frame.h"

#include <utility>

#include "frame/frame_passes.h"

namespace amalgam::frame {
namespace {

template <typename T>
void keep(const graph::FrameGraph& graph, graph::Handle<T> handle, Kept<T>& kept) {
  kept.reason = graph.reason_absent(handle);
  if (const T* value = graph.peek(handle)) kept.value = *value;
}

}  // namespace

std::optional<StillFrame> collect_still(const graph::FrameGraph& graph, const FramePasses& frame,
                                        const passes::RenderView& view) {
  StillFrame still;
  std::size_t bytes = 0;
  keep(graph, frame.mask.counts, still.counts);
  keep(graph, frame.meter_grid, still.meter_grid);

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

void StillView::begin(StillKey key) {
  seen_before_ = key_ == key;
  if (seen_before_) return;
  forget();
  key_ = std::move(key);
}

void StillView::forget() {
  *this = StillView();
}

}  // namespace amalgam::frame
