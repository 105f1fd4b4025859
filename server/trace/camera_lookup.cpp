#include "trace/camera_lookup.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "core/pose.h"
#include "scene/tone_map.h"
#include "trace/ray_offset.h"

namespace amalgam::trace {
namespace {

// Width of the band at the image's border over which the modelled colour takes over, as a share of
// the shorter side.
constexpr double kFadeShare = 0.04;

float border_trust(const core::CameraModel& camera, const glm::dvec2& pixel) {
  const double inside =
      std::min({pixel.x, pixel.y, camera.width - 1.0 - pixel.x, camera.height - 1.0 - pixel.y});
  const double band = kFadeShare * std::min(camera.width, camera.height);
  const double x = std::clamp(inside / band, 0.0, 1.0);
  return static_cast<float>(x * x * (3.0 - 2.0 * x));
}

}  // namespace

CameraLookup::CameraLookup(const CameraView& view)
    : view_(view), camera_in_world_(glm::vec3(core::rigid_inverse(view.camera_from_world)[3])) {}

std::optional<CameraSample> CameraLookup::look_up(const EmbreeScene& scene,
                                                  const SurfacePoint& point,
                                                  std::uint64_t& lookup_rays) const {
  const glm::vec3 to_camera = camera_in_world_ - point.position;
  if (!(glm::dot(to_camera, point.geometric_normal) > 0.0f)) return std::nullopt;  // its back

  const glm::dvec3 in_camera(view_.camera_from_world * glm::dvec4(point.position, 1.0));
  const auto pixel = core::project(view_.camera, in_camera);
  if (!pixel) return std::nullopt;
  const float trust = border_trust(view_.camera, *pixel);  // 0 outside as well
  if (!(trust > 0.0f)) return std::nullopt;

  const DepthVerdict verdict = judge_by_depth(in_camera);
  if (verdict == DepthVerdict::Hidden) return std::nullopt;
  if (verdict == DepthVerdict::Unsure) {
    ++lookup_rays;
    const glm::vec3 origin = offset_from_surface(point.position, point.geometric_normal);
    const glm::vec3 segment = camera_in_world_ - origin;
    const float distance = glm::length(segment);
    if (scene.is_occluded({origin, segment / distance, distance}, Visible::Real))
      return std::nullopt;
  }
  return CameraSample{scene::inverse_tone_map(bilinear(*pixel), view_.exposure), trust};
}

// Sure only where the four depths around the point agree with each other: next to an edge a ray
// decides.
CameraLookup::DepthVerdict CameraLookup::judge_by_depth(const glm::dvec3& in_camera) const {
  if (view_.real_depth == nullptr) return DepthVerdict::Unsure;
  const auto at = core::project(view_.ideal, in_camera);
  if (!at) return DepthVerdict::Unsure;
  const int x = static_cast<int>(std::floor(at->x)), y = static_cast<int>(std::floor(at->y));
  const core::Image32f& depth = *view_.real_depth;
  if (x < 0 || y < 0 || x + 1 >= depth.width() || y + 1 >= depth.height())
    return DepthVerdict::Unsure;

  const float z[4] = {depth.at(x, y), depth.at(x + 1, y), depth.at(x, y + 1),
                      depth.at(x + 1, y + 1)};
  const auto [nearest, farthest] = std::minmax({z[0], z[1], z[2], z[3]});
  constexpr float kContinuous =
      0.02f;  // relative step between neighbours that a slanted surface may have
  constexpr double kSlack =
      1e-4;  // relative: rounding of the rasteriser's depth and of the hit point
  constexpr double kClearlyBehind = 1.02;
  if (!(farthest < nearest * (1.0f + kContinuous))) return DepthVerdict::Unsure;  // infinity too
  if (in_camera.z > farthest * kClearlyBehind) return DepthVerdict::Hidden;
  if (in_camera.z >= nearest * (1.0 - kSlack) && in_camera.z <= farthest * (1.0 + kSlack)) {
    return DepthVerdict::Visible;
  }
  return DepthVerdict::Unsure;
}

// In display-linear light, so that a mirror that magnifies the image shows what magnifying it
// would.
glm::vec3 CameraLookup::bilinear(const glm::dvec2& pixel) const {
  const core::ImageRgb8& image = *view_.image;
  const int x0 = std::clamp(static_cast<int>(std::floor(pixel.x)), 0, image.width() - 1);
  const int y0 = std::clamp(static_cast<int>(std::floor(pixel.y)), 0, image.height() - 1);
  const int x1 = std::min(x0 + 1, image.width() - 1), y1 = std::min(y0 + 1, image.height() - 1);
  const auto fx = static_cast<float>(pixel.x - x0), fy = static_cast<float>(pixel.y - y0);
  const auto texel = [&](int x, int y) { return scene::srgb_decode(image.at(x, y)); };
  return glm::mix(glm::mix(texel(x0, y0), texel(x1, y0), fx),
                  glm::mix(texel(x0, y1), texel(x1, y1), fx), fy);
}

}  // namespace amalgam::trace
