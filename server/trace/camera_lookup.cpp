#include "trace/camera_lookup.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "common/pose.h"
#include "trace/visibility_walk.h"

namespace amalgam::trace {
namespace {

// Width of the band along the image's border in which look-ups fade to the modelled color, as a
// share of the shorter side.
constexpr double kFadeShare = 0.04;

float border_trust(const common::CameraModel& camera, const glm::dvec2& pixel) {
  const double inside =
      std::min({pixel.x, pixel.y, camera.width - 1.0 - pixel.x, camera.height - 1.0 - pixel.y});
  const double band = kFadeShare * std::min(camera.width, camera.height);
  const double x = std::clamp(inside / band, 0.0, 1.0);
  return static_cast<float>(x * x * (3.0 - 2.0 * x));
}

// Whether a real surface occludes the segment. Alpha cut-outs do not.
bool is_hidden(const EmbreeScene& scene, const glm::dvec3& start, const Ray& segment) {
  if (!scene.is_occluded(start, segment, Visible::Real)) return false;  // the common case
  bool hidden = false;
  walk_visibility(scene, start, segment, Visible::Real, [&](const SurfacePoint& point, double) {
    const auto& cutoff = scene.scene().materials[point.material].alpha_cutoff;
    hidden = !cutoff || point.base_color.w >= *cutoff;
    return hidden ? std::nullopt : std::optional(Visible::Real);
  });
  return hidden;
}

}  // namespace

CameraLookup::CameraLookup(const CameraView& view)
    : view_(view), camera_in_world_(common::rigid_inverse(view.camera_from_world)[3]) {}

std::optional<CameraPlace> CameraLookup::find(const EmbreeScene& scene, const SurfacePoint& point,
                                              std::uint64_t& lookup_rays) const {
  const glm::dvec3 to_camera = camera_in_world_ - point.position;
  if (!(glm::dot(to_camera, point.geometric_normal) > 0.0)) return std::nullopt;  // its back

  const glm::dvec3 in_camera(view_.camera_from_world * glm::dvec4(point.position, 1.0));
  const auto pixel = common::project(view_.camera, in_camera);
  if (!pixel) return std::nullopt;
  const float trust = border_trust(view_.camera, *pixel);  // 0 outside as well
  if (!(trust > 0.0f)) return std::nullopt;

  const DepthVerdict verdict = judge_by_depth(in_camera);
  if (verdict == DepthVerdict::Hidden) return std::nullopt;
  if (verdict == DepthVerdict::Unsure) {
    ++lookup_rays;
    const glm::dvec3 direction = glm::normalize(to_camera);
    const glm::vec3 origin = point.ray_origin_on_line(direction);
    const double distance = glm::distance(camera_in_world_, glm::dvec3(origin));
    if (is_hidden(scene, point.position,
                  {origin, glm::vec3(direction), static_cast<float>(distance)}))
      return std::nullopt;
  }
  return CameraPlace{glm::vec2(*pixel), trust};
}

// Sure only where the four depths around the point lie on one plane, on which 1/z is bilinear in
// the image, and the point lies on it too. Next to an edge a visibility ray decides.
CameraLookup::DepthVerdict CameraLookup::judge_by_depth(const glm::dvec3& in_camera) const {
  if (view_.real_depth == nullptr) return DepthVerdict::Unsure;
  const auto at = common::project(view_.ideal, in_camera);
  if (!at) return DepthVerdict::Unsure;
  const int x = static_cast<int>(std::floor(at->x)), y = static_cast<int>(std::floor(at->y));
  const common::Image32f& depth = *view_.real_depth;
  if (x < 0 || y < 0 || x + 1 >= depth.width() || y + 1 >= depth.height())
    return DepthVerdict::Unsure;

  const float z[4] = {depth.at(x, y), depth.at(x + 1, y), depth.at(x, y + 1),
                      depth.at(x + 1, y + 1)};
  const float farthest = std::max({z[0], z[1], z[2], z[3]});
  constexpr double kClearlyBehind = 1.02;
  if (in_camera.z > farthest * kClearlyBehind) return DepthVerdict::Hidden;

  const double inverse[4] = {1.0 / z[0], 1.0 / z[1], 1.0 / z[2], 1.0 / z[3]};
  const double bend = inverse[0] + inverse[3] - inverse[1] - inverse[2];
  const double fx = at->x - x, fy = at->y - y;
  const double expected =
      std::lerp(std::lerp(inverse[0], inverse[1], fx), std::lerp(inverse[2], inverse[3], fx), fy);
  // Relative: rounding of the rasteriser's depth and of the hit point.
  constexpr double kSlack = 2e-4;
  const bool on_one_plane = std::abs(bend) < kSlack * expected;
  const bool with_it = std::abs(in_camera.z * expected - 1.0) < kSlack;
  return on_one_plane && with_it ? DepthVerdict::Visible : DepthVerdict::Unsure;
}

}  // namespace amalgam::trace
