// Adaptive super-sampling (Whitted 1980; the thesis's third future work): more samples only where
// neighbours differ.
//
// The frame is first rendered at one sample a pixel. Pixels whose layers differ from a neighbour's
// (at silhouettes, at shadow edges, inside glass) are traced again at n x n samples. This includes
// diffuse surfaces, which the tracer shades as the rasteriser does. So refined shadow edges come
// from shadow rays and not from the shadow map.
#pragma once

#include <optional>
#include <vector>

#include "core/provenance.h"
#include "core/ray_counts.h"
#include "core/truncation.h"
#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/image/trace.h"
#include "trace/first_hits.h"

namespace amalgam::passes {

inline constexpr int kAdaptiveSamplesPerSide = 3;

// Difference of neighbours' layers (display-linear) above which a shadow's edge may lie between
// them. Below it a byte differs by at most 3, even in black.
inline constexpr float kShadowEdgeThreshold = 1e-3f;

// 1 for each pixel that differs from its right, left, upper or lower neighbour, if one of the two
// shows anything virtual. They differ if color or coverage of the layers do by more than threshold
// (display-linear), or if they see different objects or distances (by more than 2 %). hits: null to
// compare only the layers.
common::Image<std::uint8_t> find_edges(const core::Layers& layers, const trace::FirstHits* hits,
                                       float threshold);

// The tiles that exist in the layers and their neighbours: edges lie only there. Ascending.
std::vector<std::size_t> tiles_with_neighbours(const core::Layers& layers);

struct Refinement {
  core::RayCounts rays;  // first hits as primary
  std::uint64_t pixels = 0;
  std::uint64_t nonfinite = 0;
  core::TruncationBound truncation{};  // of the refined pixels
  // Of the refined pixels, if TraceInputs::keep_provenance.
  common::Image<std::uint8_t> marked{};  // 1: refined
  std::optional<core::ProvenanceImage> provenance{};
};

struct RefineInputs {
  TraceInputs trace;  // its specular and mask handles are not used
  float threshold = 0.0f;
  int samples_per_side = kAdaptiveSamplesPerSide;
  bool by_surface = true;      // compare objects and distances too, not only the layers
  graph::Handle<Layers> base;  // merged, before refinement
};

struct RefineOutputs {
  graph::Handle<Layers> layers;
  graph::Handle<Refinement> statistics;
};

RefineOutputs add_refine_pass(graph::FrameGraph& graph, const RefineInputs& in);

}  // namespace amalgam::passes
