// Adaptive super-sampling (Whitted 1980; the thesis's third future work): more samples only where
// neighbours differ.
//
// The frame is made at one sample a pixel. Where a pixel differs from a neighbour in what it adds
// to the picture, and so at silhouettes, edges of shadows and inside glass, all of its light is
// traced again at n x n samples, diffuse surfaces included: the tracer shades them as the
// rasteriser does. A shadow's edge thus comes from rays and not from the shadow map.
#pragma once

#include <optional>
#include <vector>

#include "core/provenance.h"
#include "core/ray_counts.h"
#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/image/trace.h"
#include "trace/first_hits.h"

namespace amalgam::passes {

inline constexpr int kAdaptiveSamplesPerSide = 3;

// A step in the layers (display-linear) beyond which a neighbour may lie across a shadow's edge:
// below it a byte differs by at most 3, even in black.
inline constexpr float kShadowEdgeThreshold = 1e-3f;

// 1 for each pixel that differs from its right, left, upper or lower neighbour: in color or
// coverage of the layers by more than threshold (display-linear), or in the object that it sees or
// its distance (by more than 2 %), if one of the two shows anything virtual at all.
// Without hits only the layers count.
common::Image<std::uint8_t> find_edges(const core::Layers& layers, const trace::FirstHits* hits,
                                       float threshold);

// The tiles that show something, and those around them: edges lie nowhere else. Ascending.
std::vector<std::size_t> tiles_with_neighbours(const core::Layers& layers);

struct Refinement {
  core::RayCounts rays;  // first hits as primary
  std::uint64_t pixels = 0;
  std::uint64_t nonfinite = 0;
  // Of the pixels taken again, if TraceInputs::keep_provenance.
  common::Image<std::uint8_t> marked{};  // 1: taken again
  std::optional<core::ProvenanceImage> provenance{};
};

struct RefineInputs {
  TraceInputs trace;  // its specular and mask handles are not used
  float threshold = 0.0f;
  int samples_per_side = kAdaptiveSamplesPerSide;
  bool by_surface = true;      // objects and distances count, not only the layers
  graph::Handle<Layers> base;  // merged, before refinement
};

struct RefineOutputs {
  graph::Handle<Layers> layers;
  graph::Handle<Refinement> statistics;
};

RefineOutputs add_refine_pass(graph::FrameGraph& graph, const RefineInputs& in);

}  // namespace amalgam::passes
