// Where a pixel's light comes from. It measures the thesis's "missing information" (section 6.4).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "common/image.h"

namespace amalgam::core {

enum class LightSource : std::uint8_t {
  Raster,         // drawn by the rasteriser
  TracedVirtual,  // a virtual diffuse surface at the end of a ray
  // The camera's own color of a real surface at the end of a ray, or under the pixel.
  CameraLookup,
  ModelledReal,  // the modelled color of a real surface that the camera does not see
  Environment,   // a ray that left the scene
  // The environment, for a ray ended by the depth limit or the importance cut-off.
  CutOff,
};
inline constexpr std::size_t kLightSources = 6;
inline constexpr std::array<const char*, kLightSources> kLightSourceNames{
    "raster", "traced_virtual", "camera_lookup", "modelled_real", "environment", "cut_off"};

// Shares by LightSource. A ray's share is the mean of its weight's channels. A sample's shares sum
// to at most 1; colored mirrors and glass absorb the rest.
using Provenance = std::array<float, kLightSources>;
using ProvenanceImage = common::Image<Provenance>;  // means over the samples of each pixel

inline void add_share(Provenance& provenance, LightSource source, float share) {
  provenance[static_cast<std::size_t>(source)] += share;
}

}  // namespace amalgam::core
