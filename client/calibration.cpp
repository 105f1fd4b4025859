#include "client/calibration.h"

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>
#include <stdexcept>

#include "client/opencv_file.h"

namespace amalgam::client {
namespace {

constexpr int kTiltedCoefficients = 14;  // OpenCV's longest model: 12 of ours and 2 of a tilt

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  fail_file("calibration", file, what);
}

cv::Mat read_matrix(const cv::FileStorage& storage, const char* key,
                    const std::filesystem::path& file) {
  const cv::FileNode node = storage[key];
  if (node.empty()) fail(file, std::string("has no ") + key);
  cv::Mat matrix;
  node >> matrix;
  if (matrix.empty() && node.isMap()) fail(file, std::string(key) + " is not an OpenCV matrix");
  if (!matrix.empty() && matrix.channels() != 1) fail(file, std::string(key) + " has channels");
  cv::Mat as_double;
  matrix.convertTo(as_double, CV_64F);
  return as_double;
}

void read_intrinsics(const cv::Mat& k, const std::filesystem::path& file,
                     common::CameraModel& camera) {
  if (k.rows != 3 || k.cols != 3) {
    fail(file, "camera_matrix is " + std::to_string(k.rows) + "x" + std::to_string(k.cols) +
                   " and not 3x3");
  }
  if (!cv::checkRange(k)) fail(file, "camera_matrix has a number that is not finite");
  camera.fx = k.at<double>(0, 0);
  camera.fy = k.at<double>(1, 1);
  camera.cx = k.at<double>(0, 2);
  camera.cy = k.at<double>(1, 2);
  if (!(camera.fx > 0) || !(camera.fy > 0)) fail(file, "focal lengths must be positive");
  const bool pinhole = k.at<double>(1, 0) == 0 && k.at<double>(2, 0) == 0 &&
                       k.at<double>(2, 1) == 0 && k.at<double>(2, 2) == 1;
  if (!pinhole) fail(file, "camera_matrix is not of the form [fx 0 cx; 0 fy cy; 0 0 1]");
  constexpr double kMaxSkew = 1e-6;  // of a focal length: rounding, not a sheared sensor
  if (std::abs(k.at<double>(0, 1)) > kMaxSkew * camera.fx) fail(file, "skew is not supported");
}

void read_distortion(const cv::Mat& coefficients, const std::filesystem::path& file,
                     common::CameraModel& camera) {
  const auto count = static_cast<int>(coefficients.total());
  if (count > 0 && coefficients.rows != 1 && coefficients.cols != 1) {
    fail(file, "distortion_coefficients is not a row or a column");
  }
  if (count > kTiltedCoefficients) fail(file, "more than 14 distortion coefficients");
  for (int i = 0; i < count; ++i) {
    const double value = coefficients.at<double>(i);
    if (!std::isfinite(value)) fail(file, "a distortion coefficient is not finite");
    if (static_cast<std::size_t>(i) < camera.distortion.size()) {
      camera.distortion[static_cast<std::size_t>(i)] = value;
    } else if (value != 0) {
      fail(file, "a tilted sensor (distortion coefficients 13 and 14) is not supported");
    }
  }
}

void read_size(const cv::FileStorage& storage, const std::filesystem::path& file,
               common::CameraModel& camera) {
  const cv::FileNode width = storage["image_width"], height = storage["image_height"];
  if (width.empty() && height.empty()) return;
  if (!width.isInt() || !height.isInt() || static_cast<int>(width) < 1 ||
      static_cast<int>(height) < 1) {
    fail(file, "image_width and image_height must both be positive whole numbers");
  }
  camera.width = static_cast<int>(width);
  camera.height = static_cast<int>(height);
}

// Lengths scale about the image's corner, which lies half a pixel before the first pixel's centre.
double scaled_position(double position, double scale) {
  return (position + 0.5) * scale - 0.5;
}

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

common::CameraModel load_calibration(const std::filesystem::path& file) {
  const std::string text = read_small_text("calibration", file);
  const QuietOpenCv quiet;
  common::CameraModel camera;
  try {
    const cv::FileStorage storage(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    if (!storage.isOpened()) fail(file, "is not an OpenCV calibration file");
    const cv::FileNode fisheye = storage["fisheye_model"];
    if (fisheye.isInt() && static_cast<int>(fisheye) != 0) {
      fail(file, "the fisheye lens model is not supported");
    }
    read_intrinsics(read_matrix(storage, "camera_matrix", file), file, camera);
    read_distortion(read_matrix(storage, "distortion_coefficients", file), file, camera);
    read_size(storage, file, camera);
  } catch (const cv::Exception& error) {
    std::string reason = error.err;
    reason = reason.substr(0, reason.find('\n'));
    fail(file, "is not an OpenCV calibration file (" + reason + ")");
  }
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
    camera.fx = calibration.fx * scale;
    camera.fy = calibration.fy * scale_y;
    camera.cx = scaled_position(calibration.cx, scale);
    camera.cy = scaled_position(calibration.cy, scale_y);
  }
  if (const std::string defect = common::describe_defect(camera); !defect.empty()) {
    throw std::runtime_error("the calibration cannot be used: " + defect);
  }
  return camera;
}

}  // namespace amalgam::client
