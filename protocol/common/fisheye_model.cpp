#include "common/fisheye_model.h"

#include <cmath>
#include <numbers>

namespace amalgam::common {
namespace {

// Rounding may put a direction at exactly the largest angle a little beyond it.
constexpr double kAngleSlack = 1e-12;

}  // namespace

std::string describe_defect(const FisheyeModel& fisheye) {
  constexpr int kMaxSide = 8192;
  if (fisheye.width < 1 || fisheye.height < 1 || fisheye.width > kMaxSide ||
      fisheye.height > kMaxSide) {
    return "image size " + std::to_string(fisheye.width) + "x" + std::to_string(fisheye.height) +
           " is not within 1x1 and 8192x8192";
  }
  // All comparisons are written so that a NaN fails.
  const auto focal_ok = [](double f) { return f >= 1.0 && f <= 1e6; };
  if (!focal_ok(fisheye.fx) || !focal_ok(fisheye.fy)) {
    return "focal length is not within 1 and 1e6 pixels for each radian";
  }
  if (!(std::abs(fisheye.cx) <= 10.0 * fisheye.width) ||
      !(std::abs(fisheye.cy) <= 10.0 * fisheye.height)) {
    return "principal point is not within ten image sides";
  }
  if (!(fisheye.max_angle > 0.0 && fisheye.max_angle <= std::numbers::pi + kAngleSlack)) {
    return "largest angle is not above 0 and at most pi";
  }
  return {};
}

std::optional<glm::dvec2> project(const FisheyeModel& fisheye, const glm::dvec3& direction) {
  const double across = std::hypot(direction.x, direction.y);
  const double angle = std::atan2(across, direction.z);
  const bool is_direction =
      std::isfinite(across) && std::isfinite(direction.z) && (across > 0.0 || direction.z != 0.0);
  if (!is_direction || !(angle <= fisheye.max_angle + kAngleSlack)) return std::nullopt;
  // On the axis every way of going by 0 is the same; straight behind, x is taken.
  const double x = across > 0.0 ? direction.x / across : 1.0;
  const double y = across > 0.0 ? direction.y / across : 0.0;
  return glm::dvec2(fisheye.cx + fisheye.fx * angle * x, fisheye.cy + fisheye.fy * angle * y);
}

std::optional<glm::dvec3> pixel_direction(const FisheyeModel& fisheye, const glm::dvec2& pixel) {
  const double x = (pixel.x - fisheye.cx) / fisheye.fx;
  const double y = (pixel.y - fisheye.cy) / fisheye.fy;
  const double angle = std::hypot(x, y);
  if (!(angle <= fisheye.max_angle + kAngleSlack)) return std::nullopt;
  const double scale = angle > 0.0 ? std::sin(angle) / angle : 1.0;
  return glm::dvec3(x * scale, y * scale, std::cos(angle));
}

}  // namespace amalgam::common
