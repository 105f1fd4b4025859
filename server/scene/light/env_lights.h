// Approximates an environment map by a few directional lights, for shading diffuse surfaces.
//
// Median cut (P. Debevec, "A Median Cut Algorithm for Light Probe Sampling", 2005) gives lights of
// similar energy. The sector binning of thesis Listing 5.1 reduces them to 8. The listing is
// corrected (numerics A2, B20): its sectors join +y and -y, where light from below cancels light
// from above, so the sectors here are the eight octants. The accumulated direction is the one that
// is normalised. An empty sector gives no light rather than NaN.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/light/environment.h"
#include "scene/light/light.h"

namespace amalgam::scene {

struct EnvLightOptions {
  enum class Method { Sectors, MedianCut };
  Method method = Method::Sectors;
  int median_cut = 128;  // lights of the median cut, 1 .. kMaxEnvLights

  bool operator==(const EnvLightOptions&) const = default;
};

constexpr int kMaxEnvLights = 4096;

// "sectors" or "median-cut:N". Throws std::invalid_argument for anything else.
EnvLightOptions parse_env_light_options(std::string_view text);
std::string to_string(const EnvLightOptions& options);

// The most lights that extract_lights() gives.
int most_lights(const EnvLightOptions& options);

// Directional lights, brightest first. Their intensities (radiance x solid angle) sum to the map's
// energy, except for dropped sectors with less than 1e-6 of it. A low-dynamic-range map's
// display-linear values count as radiance. A black or empty map gives no lights.
std::vector<Light> extract_lights(const Environment& environment, const EnvLightOptions& options);

// The two steps. median_cut() gives at most count lights: regions of one texel cannot be divided,
// and black ones are left out. bin_into_octants() takes directional lights and gives at most 8.
std::vector<Light> median_cut(const Environment& environment, int count);
std::vector<Light> bin_into_octants(std::span<const Light> lights);

}  // namespace amalgam::scene
