// Environment map to a few directional lights, for surfaces that are shaded and not traced.
//
// Median cut (P. Debevec, "A Median Cut Algorithm for Light Probe Sampling", 2005) gives lights of
// similar energy; the sector binning of thesis Listing 5.1 reduces those to 8. The listing is
// mended (numerics A2, B20): its sectors put +y and -y into one, where they cancel and light from
// below drags that from above down to the horizon, so the sectors here are the eight octants; what
// is accumulated is what is normalised; an empty sector gives no light rather than NaN.
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
  int median_cut = 128;  // lights before binning, or kept; 1 .. kMaxEnvLights

  bool operator==(const EnvLightOptions&) const = default;
};

constexpr int kMaxEnvLights = 4096;

// "sectors" or "median-cut:N". Throws std::invalid_argument for anything else.
EnvLightOptions parse_env_light_options(std::string_view text);
std::string to_string(const EnvLightOptions& options);

// The number of lights that extract_lights() gives at most.
int most_lights(const EnvLightOptions& options);

// Directional lights whose intensities (radiance x solid angle) sum to the map's whole energy,
// apart from sectors dropped for having less than 1e-6 of it. Brightest first. A low-dynamic-range
// map's display-linear values count as radiance. A black or empty map gives no lights.
std::vector<Light> extract_lights(const Environment& environment, const EnvLightOptions& options);

// The two steps. median_cut() gives at most count lights: regions of one texel cannot be divided
// and black ones are left out. bin_into_octants() gives at most 8 and takes directional lights
// only.
std::vector<Light> median_cut(const Environment& environment, int count);
std::vector<Light> bin_into_octants(std::span<const Light> lights);

}  // namespace amalgam::scene
