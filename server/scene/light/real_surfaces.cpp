#include "scene/light/real_surfaces.h"

#include <glm/common.hpp>
#include <stdexcept>
#include <string>

namespace amalgam::scene {
namespace {

// The ratio's share, by the exposed real radiance.
constexpr float kNoRatioBelow = 0x1p-10f, kAllRatioAbove = 0x1p-8f;

glm::vec3 ratio_share(const glm::vec3& real, const ToneMap& tone_map, RealSurfaces real_surfaces) {
  if (real_surfaces == RealSurfaces::Difference) return glm::vec3(0.0f);
  return glm::clamp((tone_map.exposure * real - kNoRatioBelow) / (kAllRatioAbove - kNoRatioBelow),
                    0.0f, 1.0f);
}

// m / r where it counts, 1 elsewhere.
glm::vec3 ratio(const glm::vec3& mixed, const glm::vec3& real, const glm::vec3& share) {
  glm::vec3 result(1.0f);
  for (int i = 0; i < 3; ++i) {
    if (share[i] > 0.0f) result[i] = mixed[i] / real[i];
  }
  return result;
}

}  // namespace

RealSurfaces parse_real_surfaces(std::string_view text) {
  for (const RealSurfaces choice : {RealSurfaces::Ratio, RealSurfaces::Difference}) {
    if (text == real_surfaces_name(choice)) return choice;
  }
  throw std::invalid_argument("real surfaces '" + std::string(text) +
                              "' are neither ratio nor difference");
}

const char* real_surfaces_name(RealSurfaces real_surfaces) {
  return real_surfaces == RealSurfaces::Ratio ? "ratio" : "difference";
}

LightChange light_change(const glm::vec3& mixed, const glm::vec3& real, const ToneMap& tone_map,
                         RealSurfaces real_surfaces) {
  if (mixed == real) return {};
  const glm::vec3 share = ratio_share(real, tone_map, real_surfaces);
  const glm::vec3 difference = scene::tone_map(mixed, tone_map) - scene::tone_map(real, tone_map);
  return {share * (ratio(mixed, real, share) - 1.0f), (1.0f - share) * difference};
}

glm::vec3 change_radiance(const glm::vec3& seen, const glm::vec3& mixed, const glm::vec3& real,
                          const ToneMap& tone_map, RealSurfaces real_surfaces) {
  if (mixed == real) return seen;
  const glm::vec3 share = ratio_share(real, tone_map, real_surfaces);
  const glm::vec3 by_difference = glm::max(seen + (mixed - real), glm::vec3(0.0f));
  return glm::mix(by_difference, seen * ratio(mixed, real, share), share);
}

glm::vec3 scale_light(const glm::vec3& camera, const glm::vec3& q, ToneCurve curve) {
  const ToneMap response = tone_map_of(1.0f, curve);
  const glm::vec3 scaled = tone_map(q * inverse_tone_map(camera, response), response);
  return {q.x == 1.0f ? camera.x : scaled.x, q.y == 1.0f ? camera.y : scaled.y,
          q.z == 1.0f ? camera.z : scaled.z};
}

}  // namespace amalgam::scene
