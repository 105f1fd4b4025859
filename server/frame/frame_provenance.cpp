#include "frame/frame_provenance.h"

namespace amalgam::frame {
namespace {

// The rasteriser drew the mask's surfaces that are not specular.
void add_rasterised(core::ProvenanceImage& provenance, const passes::SampleMask& mask) {
  const int n = mask.flags.width() / provenance.width();  // samples a side
  const float share = 1.0f / static_cast<float>(n * n);
  for (int y = 0; y < mask.flags.height(); ++y) {
    for (int x = 0; x < mask.flags.width(); ++x) {
      const std::uint8_t flags = mask.flags.at(x, y);
      if ((flags & passes::SampleMask::kSurface) == 0) continue;
      if ((flags & passes::SampleMask::kSpecular) != 0) continue;
      core::add_share(provenance.at(x / n, y / n), core::LightSource::Raster, share);
    }
  }
}

void replace_refined(core::ProvenanceImage& provenance, const passes::Refinement& refinement) {
  for (int y = 0; y < provenance.height(); ++y) {
    for (int x = 0; x < provenance.width(); ++x) {
      if (refinement.marked.at(x, y) == 0) continue;
      provenance.at(x, y) = refinement.provenance->at(x, y);
    }
  }
}

}  // namespace

std::optional<core::ProvenanceImage> frame_provenance(const graph::FrameGraph& graph,
                                                      const FramePasses& frame,
                                                      const passes::RenderView& view) {
  const trace::TraceResult* traced = graph.peek(frame.traced);
  const passes::SampleMask* mask = graph.peek(frame.mask.mask);
  std::optional<core::ProvenanceImage> provenance;
  if (traced != nullptr) provenance = traced->provenance;
  if (mask != nullptr) {
    if (!provenance) provenance.emplace(view.ideal.width, view.ideal.height);
    add_rasterised(*provenance, *mask);
  }
  const passes::Refinement* refinement = graph.peek(frame.refinement);
  if (provenance && refinement != nullptr) replace_refined(*provenance, *refinement);
  return provenance;
}

}  // namespace amalgam::frame
