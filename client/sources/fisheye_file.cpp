#include "client/sources/fisheye_file.h"

#include <cmath>
#include <glm/trigonometric.hpp>
#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>

#include "common/camera_model.h"
#include "common/pose.h"
#include "tracking/opencv_file.h"

namespace amalgam::client {
namespace {

using std::filesystem::path;

constexpr const char* kKind = "fish-eye calibration";

[[noreturn]] void fail(const path& file, const std::string& what) {
  tracking::fail_file(kKind, file, what);
}

// A number; if it is missing, the default, if given.
double read_number(const cv::FileNode& node, const path& file, const char* key, double missing) {
  if (node.empty()) return missing;
  if (!node.isInt() && !node.isReal()) fail(file, std::string(key) + " is not a number");
  return static_cast<double>(node);
}

cv::Matx33d read_intrinsics(const cv::FileNode& node, const path& file) {
  cv::Mat matrix;
  if (!node.isMap()) fail(file, "has no camera_matrix");
  node >> matrix;
  if (matrix.rows != 3 || matrix.cols != 3 || matrix.channels() != 1) {
    fail(file, "camera_matrix is not 3x3");
  }
  cv::Matx33d k;
  matrix.convertTo(k, CV_64F);
  const bool pinhole = k(0, 1) == 0 && k(1, 0) == 0 && k(2, 0) == 0 && k(2, 1) == 0 && k(2, 2) == 1;
  if (!pinhole) fail(file, "camera_matrix is not of the form [fx 0 cx; 0 fy cy; 0 0 1]");
  return k;
}

void check_distortion(const cv::FileNode& node, const path& file) {
  if (node.empty()) return;
  cv::Mat coefficients;
  node >> coefficients;
  if (!coefficients.empty() && cv::countNonZero(coefficients.reshape(1)) > 0) {
    fail(file, "only the equidistant model is supported: distortion_coefficients must be 0");
  }
}

glm::dquat read_rotation(const cv::FileNode& node, const path& file) {
  if (!node.isSeq() || node.size() != 4) {
    fail(file, "world_from_fisheye must be four numbers x y z w");
  }
  std::array<double, 4> q{};
  for (std::size_t i = 0; i < q.size(); ++i) {
    q[i] = read_number(node[static_cast<int>(i)], file, "world_from_fisheye", NAN);
  }
  const glm::dquat rotation(q[3], q[0], q[1], q[2]);
  if (!common::is_unit(rotation)) fail(file, "world_from_fisheye is no unit quaternion");
  return glm::normalize(rotation);
}

FisheyeCalibration read(const cv::FileStorage& storage, const path& file, int width, int height) {
  const cv::Matx33d k = read_intrinsics(storage["camera_matrix"], file);
  check_distortion(storage["distortion_coefficients"], file);
  const double own_width = read_number(storage["image_width"], file, "image_width", width);
  const double own_height = read_number(storage["image_height"], file, "image_height", height);
  const double scale_x = width / own_width, scale_y = height / own_height;
  if (!(scale_x > 0) || !(std::abs(own_height * scale_x - height) <= 1.0)) {
    fail(file, "is for an image of another shape than " + std::to_string(width) + "x" +
                   std::to_string(height));
  }
  constexpr double kHalfTurn = 90.0;
  const double degrees =
      read_number(storage["max_angle_degrees"], file, "max_angle_degrees", kHalfTurn);
  FisheyeCalibration calibration;
  calibration.lens = {.width = width,
                      .height = height,
                      .fx = k(0, 0) * scale_x,
                      .fy = k(1, 1) * scale_y,
                      .cx = common::scaled_position(k(0, 2), scale_x),
                      .cy = common::scaled_position(k(1, 2), scale_y),
                      .max_angle = glm::radians(degrees)};
  calibration.world_from_fisheye = read_rotation(storage["world_from_fisheye"], file);
  return calibration;
}

}  // namespace

FisheyeCalibration load_fisheye(const path& file, int width, int height) {
  const std::string text = tracking::read_small_text(kKind, file);
  const tracking::QuietOpenCv quiet;
  try {
    const cv::FileStorage storage(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    const FisheyeCalibration calibration = read(storage, file, width, height);
    const std::string defect = common::describe_defect(calibration.lens);
    if (!defect.empty()) fail(file, defect);
    return calibration;
  } catch (const cv::Exception& error) {
    fail(file, "is not an OpenCV file (" + tracking::first_line(error) + ")");
  }
}

}  // namespace amalgam::client
