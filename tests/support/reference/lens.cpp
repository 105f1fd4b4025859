#include "support/reference/lens.h"

#include <cmath>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

namespace amalgam::reference {
namespace {

// By central differences: slower than the derivatives written out, and nothing to get wrong.
glm::dmat2 jacobian(const common::CameraModel& camera, const Vec2& ideal) {
  constexpr double kStep = 1e-5;
  const auto along = [&](const Vec2& step) {
    return (lens_distort(camera, ideal + step) - lens_distort(camera, ideal - step)) /
           (2.0 * kStep);
  };
  return {along({kStep, 0.0}), along({0.0, kStep})};
}

// The model is one to one as long as its determinant has not changed sign on the way from the axis.
bool before_fold(const common::CameraModel& camera, const Vec2& ideal) {
  constexpr int kSteps = 64;
  for (int i = 1; i <= kSteps; ++i) {
    const Vec2 on_the_way = ideal * (static_cast<double>(i) / kSteps);
    if (!(glm::determinant(jacobian(camera, on_the_way)) > 0.0)) return false;
  }
  return true;
}

bool distorts(const common::CameraModel& camera) {
  return std::any_of(camera.distortion.begin(), camera.distortion.end(),
                     [](double coefficient) { return coefficient != 0.0; });
}

}  // namespace

Vec2 lens_distort(const common::CameraModel& camera, const Vec2& ideal) {
  const auto& [k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4] = camera.distortion;
  const double x = ideal.x, y = ideal.y;
  const double r2 = x * x + y * y, r4 = r2 * r2, r6 = r4 * r2;
  const double radial = (1.0 + k1 * r2 + k2 * r4 + k3 * r6) / (1.0 + k4 * r2 + k5 * r4 + k6 * r6);
  return {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x) + s1 * r2 + s2 * r4,
          y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y + s3 * r2 + s4 * r4};
}

std::optional<Vec2> lens_undistort(const common::CameraModel& camera, const Vec2& distorted) {
  if (!distorts(camera)) return distorted;
  Vec2 ideal = distorted;
  for (int i = 0; i < 100; ++i) {
    const Vec2 error = lens_distort(camera, ideal) - distorted;
    if (glm::length(error) < 1e-12) break;
    ideal -= glm::inverse(jacobian(camera, ideal)) * error;
  }
  const bool converged = glm::length(lens_distort(camera, ideal) - distorted) < 1e-9;
  if (!converged || !before_fold(camera, ideal)) return std::nullopt;
  return ideal;
}

std::optional<Vec2> lens_project(const common::CameraModel& camera, const Vec3& point_in_camera) {
  if (!(point_in_camera.z > 1e-9)) return std::nullopt;
  Vec2 normalised = Vec2(point_in_camera) / point_in_camera.z;
  if (distorts(camera)) {
    if (!before_fold(camera, normalised)) return std::nullopt;
    normalised = lens_distort(camera, normalised);
  }
  return Vec2(camera.fx * normalised.x + camera.cx, camera.fy * normalised.y + camera.cy);
}

Vec3 pinhole_direction(const common::CameraModel& ideal, const Vec2& pixel) {
  return {(pixel.x - ideal.cx) / ideal.fx, (pixel.y - ideal.cy) / ideal.fy, 1.0};
}

std::optional<Vec2> ideal_pixel(const common::CameraModel& camera, const common::CameraModel& ideal,
                                const Vec2& pixel) {
  const auto normalised = lens_undistort(
      camera, {(pixel.x - camera.cx) / camera.fx, (pixel.y - camera.cy) / camera.fy});
  if (!normalised) return std::nullopt;
  return Vec2(ideal.fx * normalised->x + ideal.cx, ideal.fy * normalised->y + ideal.cy);
}

}  // namespace amalgam::reference
