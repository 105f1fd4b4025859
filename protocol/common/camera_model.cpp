#include "common/camera_model.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <numeric>

namespace amalgam::common {
namespace {

struct DistortedPoint {
  glm::dvec2 value;
  glm::dmat2 jacobian;  // columns: d value / d x, d value / d y
};

DistortedPoint distort_with_jacobian(const std::array<double, 12>& k, const glm::dvec2& p) {
  const double x = p.x, y = p.y;
  const double r2 = x * x + y * y;
  const double numerator = 1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]));
  const double denominator = 1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7]));
  const double radial = numerator / denominator;
  const double numerator_d = k[0] + r2 * (2 * k[1] + r2 * 3 * k[4]);
  const double denominator_d = k[5] + r2 * (2 * k[6] + r2 * 3 * k[7]);
  const double radial_d = (numerator_d - radial * denominator_d) / denominator;  // by r2
  const double prism_dx = k[8] + 2 * k[9] * r2, prism_dy = k[10] + 2 * k[11] * r2;

  DistortedPoint out;
  out.value.x = x * radial + 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x) + r2 * (k[8] + k[9] * r2);
  out.value.y = y * radial + k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y + r2 * (k[10] + k[11] * r2);
  out.jacobian[0].x =
      radial + 2 * x * x * radial_d + 2 * k[2] * y + 6 * k[3] * x + 2 * x * prism_dx;
  out.jacobian[0].y = 2 * x * y * radial_d + 2 * k[2] * x + 2 * k[3] * y + 2 * x * prism_dy;
  out.jacobian[1].x = 2 * x * y * radial_d + 2 * k[2] * x + 2 * k[3] * y + 2 * y * prism_dx;
  out.jacobian[1].y =
      radial + 2 * y * y * radial_d + 6 * k[2] * y + 2 * k[3] * x + 2 * y * prism_dy;
  return out;
}

bool is_finite(const glm::dvec2& v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}

// The map keeps orientation everywhere between the axis and p: p is on the near side of any fold.
bool is_before_fold(const CameraModel& camera, const glm::dvec2& p) {
  constexpr int kSteps = 8;
  for (int step = 1; step <= kSteps; ++step) {
    const double t = static_cast<double>(step) / kSteps;
    if (!(glm::determinant(distort_with_jacobian(camera.distortion, p * t).jacobian) > 0))
      return false;
  }
  return true;
}

glm::dvec2 normalised(const CameraModel& camera, const glm::dvec2& pixel) {
  return {(pixel.x - camera.cx) / camera.fx, (pixel.y - camera.cy) / camera.fy};
}

// Calls visit(pixel) for points along the outer border of the image, a few pixels apart.
template <typename Visit>
void walk_border(const CameraModel& camera, Visit visit) {
  constexpr int kSteps = 64;
  const double right = camera.width - 0.5, bottom = camera.height - 0.5;
  for (int step = 0; step <= kSteps; ++step) {
    const double t = static_cast<double>(step) / kSteps;
    const double x = std::lerp(-0.5, right, t), y = std::lerp(-0.5, bottom, t);
    visit(glm::dvec2(x, -0.5));
    visit(glm::dvec2(x, bottom));
    visit(glm::dvec2(-0.5, y));
    visit(glm::dvec2(right, y));
  }
}

}  // namespace

bool CameraModel::has_distortion() const {
  return std::any_of(distortion.begin(), distortion.end(), [](double k) { return k != 0.0; });
}

CameraModel camera_of_view(int width, int height, double degrees) {
  const double half = degrees * std::numbers::pi / 360.0;
  CameraModel camera;
  camera.width = width;
  camera.height = height;
  camera.fx = camera.fy = 0.5 * width / std::tan(half);
  camera.cx = 0.5 * (width - 1);
  camera.cy = 0.5 * (height - 1);
  return camera;
}

CameraModel default_camera(int width, int height) {
  return camera_of_view(width, height, 60.0);
}

std::string describe_defect(const CameraModel& camera) {
  constexpr int kMaxSide = 8192;
  if (camera.width < 1 || camera.height < 1 || camera.width > kMaxSide ||
      camera.height > kMaxSide) {
    return "image size " + std::to_string(camera.width) + "x" + std::to_string(camera.height) +
           " is not within 1x1 and 8192x8192";
  }
  const auto focal_ok = [](double f) { return f >= 1.0 && f <= 1e6; };
  if (!focal_ok(camera.fx) || !focal_ok(camera.fy))
    return "focal length is not within 1 and 1e6 pixels";
  if (!(std::abs(camera.cx) <= 10.0 * camera.width) ||
      !(std::abs(camera.cy) <= 10.0 * camera.height)) {
    return "principal point is not within ten image sides";
  }
  if (!std::all_of(camera.distortion.begin(), camera.distortion.end(),
                   [](double k) { return std::isfinite(k); })) {
    return "a distortion coefficient is not finite";
  }
  if (camera.has_distortion()) {
    bool invertible = true;
    walk_border(camera, [&](const glm::dvec2& pixel) {
      invertible = invertible && undistort(camera, normalised(camera, pixel)).has_value();
    });
    if (!invertible) return "lens distortion cannot be inverted inside the image";
  }
  return {};
}

glm::dvec2 distort(const CameraModel& camera, const glm::dvec2& ideal) {
  return distort_with_jacobian(camera.distortion, ideal).value;
}

std::optional<glm::dvec2> undistort(const CameraModel& camera, const glm::dvec2& distorted) {
  if (!camera.has_distortion()) return distorted;
  constexpr int kMaxIterations = 30;
  constexpr double kTolerance = 1e-9;
  glm::dvec2 ideal = distorted;
  for (int i = 0; i < kMaxIterations; ++i) {
    const DistortedPoint point = distort_with_jacobian(camera.distortion, ideal);
    const glm::dvec2 error = point.value - distorted;
    if (!is_finite(error)) return std::nullopt;
    const bool converged = std::max(std::abs(error.x), std::abs(error.y)) < kTolerance;
    if (!(std::abs(glm::determinant(point.jacobian)) > 1e-12)) return std::nullopt;
    ideal -= glm::inverse(point.jacobian) * error;  // the last step squares what error is left
    if (converged) return is_before_fold(camera, ideal) ? std::optional(ideal) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<glm::dvec2> project(const CameraModel& camera, const glm::dvec3& point) {
  constexpr double kMinDepth = 1e-9;
  if (!(point.z > kMinDepth)) return std::nullopt;
  glm::dvec2 p(point.x / point.z, point.y / point.z);
  if (camera.has_distortion()) {
    if (!is_before_fold(camera, p)) return std::nullopt;
    p = distort(camera, p);
  }
  return glm::dvec2(camera.fx * p.x + camera.cx, camera.fy * p.y + camera.cy);
}

std::optional<glm::dvec3> pixel_direction(const CameraModel& camera, const glm::dvec2& pixel) {
  const auto ideal = undistort(camera, normalised(camera, pixel));
  if (!ideal) return std::nullopt;
  return glm::dvec3(*ideal, 1.0);
}

CameraModel ideal_camera_covering(const CameraModel& camera) {
  CameraModel ideal = camera;
  ideal.distortion = {};
  if (!camera.has_distortion()) return ideal;

  glm::dvec2 low(-0.5), high(camera.width - 0.5, camera.height - 0.5);
  walk_border(camera, [&](const glm::dvec2& pixel) {
    if (const auto p = undistort(camera, normalised(camera, pixel))) {
      const glm::dvec2 at(camera.fx * p->x + camera.cx, camera.fy * p->y + camera.cy);
      low = glm::min(low, at);
      high = glm::max(high, at);
    }
  });
  // One more pixel on each side, so that a bilinear fetch near the border finds its neighbours.
  const auto margin = [](double outside, int side) {
    return static_cast<int>(std::min(std::ceil(outside) + 1.0, std::floor(side * 0.5)));
  };
  const int left = margin(-0.5 - low.x, camera.width), top = margin(-0.5 - low.y, camera.height);
  ideal.width += left + margin(high.x - (camera.width - 0.5), camera.width);
  ideal.height += top + margin(high.y - (camera.height - 0.5), camera.height);
  ideal.cx += left;
  ideal.cy += top;
  return ideal;
}

}  // namespace amalgam::common
