#include "scene/light/env_lights.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

#include "scene/light/luminance.h"

namespace amalgam::scene {
namespace {

constexpr int kOctants = 8;

constexpr double kPi = std::numbers::pi;

// Texels [x0, x1) x [y0, y1).
struct Region {
  int x0, y0, x1, y1;
  double energy = 0.0;  // luminance x solid angle

  bool is_divisible() const { return x1 - x0 > 1 || y1 - y0 > 1; }
};

// Energy of texels and lights of regions, in one map.
class EnergyMap {
 public:
  explicit EnergyMap(const Environment& environment)
      : environment_(environment), map_(environment.radiance) {
    for (int y = 0; y < map_.height(); ++y) {
      solid_angles_.push_back(texel_solid_angle(environment, y));
    }
  }

  glm::dvec3 color(int x, int y) const {
    return glm::dvec3(map_.at(x, y)) * solid_angles_[static_cast<std::size_t>(y)];
  }

  Region whole() const {
    Region region{0, 0, map_.width(), map_.height()};
    region.energy = energy_of(region);
    return region;
  }

  double energy_of(const Region& region) const {
    double energy = 0.0;
    for (int y = region.y0; y < region.y1; ++y) {
      for (int x = region.x0; x < region.x1; ++x) energy += luminance(color(x, y));
    }
    return energy;
  }

  // Two parts of as equal energy as texels allow, cut across the longer side as it is on the
  // sphere: columns come closer to each other towards the poles.
  std::array<Region, 2> divide(const Region& region) const {
    const double middle = kPi * 0.5 * (region.y0 + region.y1) / map_.height();
    const double width = 2.0 * kPi * (region.x1 - region.x0) / map_.width() * std::sin(middle);
    const double height = kPi * (region.y1 - region.y0) / map_.height();
    const bool by_columns =
        region.x1 - region.x0 > 1 && (width >= height || region.y1 - region.y0 == 1);
    const int low = by_columns ? region.x0 : region.y0, high = by_columns ? region.x1 : region.y1;

    std::vector<double> lines(static_cast<std::size_t>(high - low), 0.0);
    for (int y = region.y0; y < region.y1; ++y) {
      for (int x = region.x0; x < region.x1; ++x) {
        lines[static_cast<std::size_t>((by_columns ? x : y) - low)] += luminance(color(x, y));
      }
    }
    int cut = low + 1;
    double before = lines[0], best = before;
    while (cut + 1 < high) {
      const double with_next = before + lines[static_cast<std::size_t>(cut - low)];
      if (std::abs(2.0 * with_next - region.energy) > std::abs(2.0 * best - region.energy)) break;
      before = best = with_next;
      ++cut;
    }
    std::array<Region, 2> parts{region, region};
    (by_columns ? parts[0].x1 : parts[0].y1) = cut;
    (by_columns ? parts[1].x0 : parts[1].y0) = cut;
    parts[0].energy = before;
    parts[1].energy = energy_of(parts[1]);  // not the difference: that would collect rounding
    return parts;
  }

  // At the energy's centroid, taken over directions rather than texels.
  Light light_of(const Region& region) const {
    glm::dvec3 sum(0.0), centroid(0.0);
    for (int y = region.y0; y < region.y1; ++y) {
      for (int x = region.x0; x < region.x1; ++x) {
        const glm::dvec3 c = color(x, y);
        sum += c;
        centroid += luminance(c) * glm::dvec3(environment_direction(environment_, glm::vec2(x, y)));
      }
    }
    Light light;
    light.intensity = glm::vec3(sum);
    // A region as large as the whole sphere may have no centroid to speak of.
    const glm::vec2 center(0.5f * static_cast<float>(region.x0 + region.x1 - 1),
                           0.5f * static_cast<float>(region.y0 + region.y1 - 1));
    light.to_light = glm::length(centroid) > 1e-6 * region.energy
                         ? glm::vec3(glm::normalize(centroid))
                         : environment_direction(environment_, center);
    return light;
  }

 private:
  const Environment& environment_;
  const common::ImageRgb32f& map_;
  std::vector<double> solid_angles_;  // sr, by row
};

void sort_brightest_first(std::vector<Light>& lights) {
  std::stable_sort(lights.begin(), lights.end(), [](const Light& a, const Light& b) {
    return luminance(glm::dvec3(a.intensity)) > luminance(glm::dvec3(b.intensity));
  });
}

}  // namespace

EnvLightOptions parse_env_light_options(std::string_view text) {
  constexpr std::string_view kMedianCut = "median-cut:";
  EnvLightOptions options;
  if (text == "sectors") return options;
  if (text.starts_with(kMedianCut)) {
    options.method = EnvLightOptions::Method::MedianCut;
    const std::string_view number = text.substr(kMedianCut.size());
    const char* const end = number.data() + number.size();
    const auto parsed = std::from_chars(number.data(), end, options.median_cut);
    if (parsed.ec == std::errc() && parsed.ptr == end && options.median_cut >= 1 &&
        options.median_cut <= kMaxEnvLights) {
      return options;
    }
  }
  throw std::invalid_argument("'" + std::string(text) +
                              "' is neither sectors nor median-cut:N with N within 1 and " +
                              std::to_string(kMaxEnvLights));
}

std::string to_string(const EnvLightOptions& options) {
  if (options.method == EnvLightOptions::Method::Sectors) return "sectors";
  return "median-cut:" + std::to_string(options.median_cut);
}

int most_lights(const EnvLightOptions& options) {
  return options.method == EnvLightOptions::Method::Sectors ? kOctants : options.median_cut;
}

std::vector<Light> median_cut(const Environment& environment, int count) {
  std::vector<Light> lights;
  if (environment.radiance.empty()) return lights;
  const EnergyMap map(environment);
  // Always the region with most energy is divided, so that any number can be reached, not only
  // powers of two. Indivisible ones go to done.
  const auto less = [](const Region& a, const Region& b) { return a.energy < b.energy; };
  std::vector<Region> heap{map.whole()}, done;
  if (!(heap.front().energy > 0.0)) return lights;
  while (!heap.empty() && static_cast<int>(heap.size() + done.size()) < count) {
    std::pop_heap(heap.begin(), heap.end(), less);
    const Region largest = heap.back();
    heap.pop_back();
    if (!largest.is_divisible()) {
      done.push_back(largest);
      continue;
    }
    for (const Region& part : map.divide(largest)) {
      if (!(part.energy > 0.0)) continue;
      heap.push_back(part);
      std::push_heap(heap.begin(), heap.end(), less);
    }
  }
  done.insert(done.end(), heap.begin(), heap.end());
  for (const Region& region : done) lights.push_back(map.light_of(region));
  sort_brightest_first(lights);
  return lights;
}

std::vector<Light> bin_into_octants(std::span<const Light> lights) {
  constexpr double kNegligible = 1e-6;
  struct Sector {
    glm::dvec3 position{0.0}, color{0.0};
  };
  std::array<Sector, kOctants> sectors;
  double total = 0.0;
  for (const Light& light : lights) {
    const glm::vec3& d = light.to_light;
    const std::size_t index =
        (d.x > 0.0f ? 4u : 0u) + (d.z > 0.0f ? 2u : 0u) + (d.y > 0.0f ? 1u : 0u);
    const glm::dvec3 color(light.intensity);
    sectors[index].position += glm::dvec3(d) * luminance(color);
    sectors[index].color += color;
    total += luminance(color);
  }
  std::vector<Light> binned;
  for (const Sector& sector : sectors) {
    // Directions of one octant never cancel: their sum has a length of at least 1/sqrt(3) of
    // theirs.
    if (!(luminance(sector.color) > kNegligible * total)) continue;
    Light light;
    light.to_light = glm::vec3(glm::normalize(sector.position));
    light.intensity = glm::vec3(sector.color);
    binned.push_back(light);
  }
  sort_brightest_first(binned);
  return binned;
}

std::vector<Light> extract_lights(const Environment& environment, const EnvLightOptions& options) {
  std::vector<Light> lights = median_cut(environment, options.median_cut);
  return options.method == EnvLightOptions::Method::Sectors ? bin_into_octants(lights) : lights;
}

}  // namespace amalgam::scene
