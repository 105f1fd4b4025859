// The pinhole camera with OpenCV's lens distortion: maps directions to pixels and back.
//
// Camera frame: x right, y down, z forward. Pixel coordinates: (0, 0) is the *centre* of the top
// left pixel. Distortion is the Brown-Conrady model with rational and thin-prism terms,
// coefficients in OpenCV's order k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

namespace amalgam::common {

struct CameraModel {
  int width = 0;              // pixels
  int height = 0;             // pixels
  double fx = 0.0, fy = 0.0;  // focal lengths, pixels
  double cx = 0.0, cy = 0.0;  // principal point, pixels
  std::array<double, 12> distortion{};

  bool operator==(const CameraModel&) const = default;
  bool has_distortion() const;
};

// A camera without distortion, with square pixels, and so many degrees wide.
CameraModel camera_of_view(int width, int height, double degrees);
// A guess for an unknown camera: 60 degrees wide.
CameraModel default_camera(int width, int height);

// An empty string if the model can be rendered with, otherwise its defect: sides not in 1..8192,
// focal lengths not finite or not in [1, 1e6], a principal point further than ten image sides away,
// non-finite coefficients, or a distortion that folds back inside the image (not invertible).
std::string describe_defect(const CameraModel& camera);

// Ideal normalised coordinates (x/z, y/z) to distorted ones, and back. undistort() uses Newton's
// method and gives nothing if it does not converge to 1e-9 or ends on the far side of a fold.
glm::dvec2 distort(const CameraModel& camera, const glm::dvec2& ideal);
std::optional<glm::dvec2> undistort(const CameraModel& camera, const glm::dvec2& distorted);

// The pixel that sees a point of the camera frame. Nothing if it is not in front of the camera
// (z <= 1e-9 m: numerics A1, B15) or beyond where the distortion model can be inverted. The pixel
// may lie outside the image.
std::optional<glm::dvec2> project(const CameraModel& camera, const glm::dvec3& point_in_camera);

// Where a position in the image (pixel 0 is the centre of the first pixel) lies after the image is
// scaled. Lengths scale about the image's corner, half a pixel before that.
constexpr double scaled_position(double position, double scale) {
  return (position + 0.5) * scale - 0.5;
}

// The direction (z = 1, not normalised) that a pixel sees; nothing where undistort() gives nothing.
std::optional<glm::dvec3> pixel_direction(const CameraModel& camera, const glm::dvec2& pixel);

// The same camera without distortion, with margins so that it sees everything that the distorted
// one sees. Focal lengths are kept; the principal point moves by the margin. No side grows beyond
// twice its length: pixels of the camera further out are never drawn on.
CameraModel ideal_camera_covering(const CameraModel& camera);

}  // namespace amalgam::common
