// The camera's lens: which pixel sees a point, and where an ideal pinhole camera would see what a
// pixel of the real one sees. Brown-Conrady with rational and thin-prism terms, as in OpenCV.
#pragma once

#include <optional>

#include "common/camera_model.h"
#include "support/reference/vectors.h"

namespace amalgam::reference {

// Ideal normalised coordinates (x/z, y/z) to distorted ones. The model alone: beyond its fold it
// comes back inwards.
Vec2 lens_distort(const common::CameraModel& camera, const Vec2& ideal);

// The inverse, by Newton's method; nothing where that finds no solution on this side of the fold.
std::optional<Vec2> lens_undistort(const common::CameraModel& camera, const Vec2& distorted);

// The pixel (eq. 4.10, 4.11 mended: numerics A1) that sees a point of the camera frame. Nothing if
// z <= 1e-9 or if the lens model has folded before it gets there.
std::optional<Vec2> lens_project(const common::CameraModel& camera, const Vec3& point_in_camera);

// The direction (z = 1) of a pixel of a camera without distortion.
Vec3 pinhole_direction(const common::CameraModel& ideal, const Vec2& pixel);

// Where the ideal camera sees what the distorted camera's pixel sees.
std::optional<Vec2> ideal_pixel(const common::CameraModel& camera, const common::CameraModel& ideal,
                                const Vec2& pixel);

}  // namespace amalgam::reference
