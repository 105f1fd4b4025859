#include "frame/buffer_dump.h"

#include <algorithm>

#include "codec/exr.h"
#include "frame/frame_passes.h"
#include "frame/frame_provenance.h"
#include "passes/raster/read_back.h"

namespace amalgam::frame {
namespace {

// The first sample of each pixel.
template <typename Pixel>
common::Image<Pixel> first_samples(const common::Image<Pixel>& samples,
                                   const passes::RenderView& view) {
  const int n = view.samples_per_side;
  common::Image<Pixel> first(view.ideal.width, view.ideal.height);
  for (int y = 0; y < first.height(); ++y) {
    for (int x = 0; x < first.width(); ++x) first.at(x, y) = samples.at(x * n, y * n);
  }
  return first;
}

struct ThesisBuffers {
  explicit ThesisBuffers(const passes::RenderView& view)
      : mixed(view.ideal.width, view.ideal.height),
        real(view.ideal.width, view.ideal.height),
        environment_reflection(view.ideal.width, view.ideal.height),
        virtual_mask(view.ideal.width, view.ideal.height) {}

  void add(const common::ImageRgba32f& rasterised_mixed,
           const common::ImageRgba32f& rasterised_real) {
    for (int y = 0; y < mixed.height(); ++y) {
      for (int x = 0; x < mixed.width(); ++x) {
        mixed.at(x, y) += glm::vec3(rasterised_mixed.at(x, y));
        real.at(x, y) += glm::vec3(rasterised_real.at(x, y));
        virtual_mask.at(x, y) = std::max(virtual_mask.at(x, y), rasterised_mixed.at(x, y).w);
      }
    }
  }
  void add(const trace::TracedImages& traced) {
    for (int y = 0; y < mixed.height(); ++y) {
      for (int x = 0; x < mixed.width(); ++x) {
        mixed.at(x, y) += traced.mixed.at(x, y);
        real.at(x, y) += glm::vec3(traced.real.at(x, y));
        environment_reflection.at(x, y) += traced.environment_reflection.at(x, y);
        virtual_mask.at(x, y) =
            std::max(virtual_mask.at(x, y), static_cast<float>(traced.met_virtual.at(x, y)));
      }
    }
  }

  common::ImageRgb32f mixed, real, environment_reflection;
  common::Image32f virtual_mask;
};

common::Image32f tracing_mask(const common::Image<std::uint8_t>& flags) {
  common::Image32f mask(flags.width(), flags.height());
  std::transform(flags.pixels().begin(), flags.pixels().end(), mask.data(), [](std::uint8_t flag) {
    return (flag & passes::SampleMask::kSpecular) != 0 ? 1.0f : 0.0f;
  });
  return mask;
}

Channels provenance_channels(const core::ProvenanceImage& provenance) {
  Channels channels;
  for (std::size_t k = 0; k < core::kLightSources; ++k) {
    common::Image32f channel(provenance.width(), provenance.height());
    std::transform(provenance.pixels().begin(), provenance.pixels().end(), channel.data(),
                   [k](const core::Provenance& shares) { return shares[k]; });
    channels.emplace_back(core::kLightSourceNames[k], std::move(channel));
  }
  return channels;
}

}  // namespace

FrameBuffers collect_buffers(const graph::FrameGraph& graph, const FramePasses& frame,
                             const passes::RenderView& view) {
  FrameBuffers buffers;
  ThesisBuffers thesis(view);
  const passes::DeviceImage* mixed = graph.peek(frame.diffuse.mixed);
  const passes::DeviceImage* real = graph.peek(frame.diffuse.real);
  const trace::TraceResult* traced = graph.peek(frame.traced);
  if (mixed != nullptr && real != nullptr) {
    thesis.add(first_samples(passes::read_rgba(*mixed), view),
               first_samples(passes::read_rgba(*real), view));
  }
  if (traced != nullptr && traced->images) thesis.add(*traced->images);
  if (mixed != nullptr || traced != nullptr) {
    buffers.emplace("mixed", std::move(thesis.mixed));
    buffers.emplace("real", std::move(thesis.real));
    buffers.emplace("environment_reflection", std::move(thesis.environment_reflection));
    buffers.emplace("virtual_mask", std::move(thesis.virtual_mask));
  }
  if (const auto provenance = frame_provenance(graph, frame, view)) {
    buffers.emplace("provenance", provenance_channels(*provenance));
  }
  if (const passes::SampleMask* mask = graph.peek(frame.mask.mask)) {
    buffers.emplace("tracing_mask", tracing_mask(first_samples(mask->flags, view)));
  }
  if (const passes::RealDepth* depth = graph.peek(frame.real_depth)) {
    buffers.emplace("real_depth", depth->z);
  }
  if (const passes::Layers* layers = graph.peek(frame.layers)) {
    buffers.emplace("over", layers->over_image());
    buffers.emplace("difference", layers->difference_image());
    buffers.emplace("light_ratio", layers->light_ratio_image());
  }
  return buffers;
}

void write_buffers(const FrameBuffers& buffers, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const auto& [name, buffer] : buffers) {
    const bool is_averaged = name == "over" || name == "difference";
    const std::string comments = is_averaged ? "average of each pixel's samples, after refinement"
                                             : "first sample of each pixel, before refinement";
    std::visit(
        [&](const auto& image) { codec::write_exr(folder / (name + ".exr"), image, comments); },
        buffer);
  }
}

}  // namespace amalgam::frame
