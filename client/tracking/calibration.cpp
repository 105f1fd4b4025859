#include "client/tracking/calibration.h"

#include <cmath>
#include <stdexcept>

#include "client/tracking/calibration_file.h"
#include "common/log.h"
#include "tracking/opencv_file.h"

namespace amalgam::client {
namespace {

constexpr std::size_t kTiltedCoefficients =
    14;  // OpenCV's longest model: 12 of ours and 2 of a tilt

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  tracking::fail_file("calibration", file, what);
}

void read_intrinsics(const std::array<double, 9>& k, const std::filesystem::path& file,
                     common::CameraModel& camera) {
  for (const double number : k) {
    if (!std::isfinite(number)) fail(file, "the camera matrix has a number that is not finite");
  }
  camera.fx = k[0];
  camera.fy = k[4];
  camera.cx = k[2];
  camera.cy = k[5];
  if (!(camera.fx > 0) || !(camera.fy > 0)) fail(file, "focal lengths must be positive");
  const bool pinhole = k[3] == 0 && k[6] == 0 && k[7] == 0 && k[8] == 1;
  if (!pinhole) fail(file, "the camera matrix is not of the form [fx 0 cx; 0 fy cy; 0 0 1]");
  constexpr double kMaxSkew = 1e-6;  // of a focal length: rounding, not a sheared sensor
  if (std::abs(k[1]) > kMaxSkew * camera.fx) fail(file, "skew is not supported");
}

void read_distortion(const std::vector<double>& coefficients, const std::filesystem::path& file,
                     common::CameraModel& camera) {
  if (coefficients.size() > kTiltedCoefficients) fail(file, "more than 14 distortion coefficients");
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const double value = coefficients[i];
    if (!std::isfinite(value)) fail(file, "a distortion coefficient is not finite");
    if (i < camera.distortion.size()) {
      camera.distortion[i] = value;
    } else if (value != 0) {
      fail(file, "a tilted sensor (distortion coefficients 13 and 14) is not supported");
    }
  }
}

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

common::CameraModel load_calibration(const std::filesystem::path& file) {
  const CalibrationNumbers numbers = read_calibration_file(file);
  common::CameraModel camera;
  camera.width = numbers.width;
  camera.height = numbers.height;
  read_intrinsics(numbers.matrix, file, camera);
  read_distortion(numbers.distortion, file, camera);
  if (camera.width > 0) {
    if (const std::string defect = common::describe_defect(camera); !defect.empty()) {
      fail(file, defect);
    }
  }
  return camera;
}

common::CameraModel fit_to_image(const common::CameraModel& calibration, int width, int height) {
  common::CameraModel camera = calibration;
  camera.width = width;
  camera.height = height;
  if (calibration.width == 0) {
    const bool inside =
        camera.cx > -0.5 && camera.cx < width - 0.5 && camera.cy > -0.5 && camera.cy < height - 0.5;
    if (!inside) {
      throw std::runtime_error("the calibration's principal point lies outside the image of " +
                               size_text(width, height) + ": it is for another image size");
    }
  } else if (calibration.width != width || calibration.height != height) {
    const double scale = static_cast<double>(width) / calibration.width;
    const double scale_y = static_cast<double>(height) / calibration.height;
    if (std::abs(calibration.height * scale - height) > 1.0) {
      throw std::runtime_error("the calibration is for " +
                               size_text(calibration.width, calibration.height) +
                               " and the image is " + size_text(width, height) +
                               ": that is a crop, which it cannot be converted for");
    }
    common::log_warn("the calibration is for " + size_text(calibration.width, calibration.height) +
                     " and scaled to " + size_text(width, height));
    camera.fx = calibration.fx * scale;
    camera.fy = calibration.fy * scale_y;
    camera.cx = common::scaled_position(calibration.cx, scale);
    camera.cy = common::scaled_position(calibration.cy, scale_y);
  }
  if (const std::string defect = common::describe_defect(camera); !defect.empty()) {
    throw std::runtime_error("the calibration cannot be used: " + defect);
  }
  return camera;
}

}  // namespace amalgam::client
