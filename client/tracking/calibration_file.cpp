#include "client/tracking/calibration_file.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>
#include <string>

#include "tracking/opencv_file.h"

namespace amalgam::client {
namespace {

using std::filesystem::path;

[[noreturn]] void fail(const path& file, const std::string& what) {
  tracking::fail_file("calibration", file, what);
}

// The first of the names that the file has.
cv::FileNode find(const cv::FileNode& holder, const std::vector<const char*>& names) {
  for (const char* name : names) {
    const cv::FileNode node = holder[name];
    if (!node.empty()) return node;
  }
  return {};
}

void append_numbers(const cv::FileNode& node, const path& file, std::vector<double>& numbers) {
  if (node.isInt() || node.isReal()) {
    numbers.push_back(static_cast<double>(node));
  } else if (node.isSeq()) {
    for (const cv::FileNode& item : node) append_numbers(item, file, numbers);
  } else if (!node.isNone()) {
    fail(file, "has '" + (node.isString() ? std::string(node) : std::string("a map")) +
                   "' where a number must stand");
  }
}

struct Matrix {
  std::vector<double> numbers;  // row by row
  int rows = 0, cols = 0;       // 0 if the file does not say
};

// A list, a list of rows, or a map of rows, cols and data (OpenCV's and ROS's matrices).
Matrix read_matrix(const cv::FileNode& node, const path& file) {
  Matrix matrix;
  if (!node.isMap()) {
    append_numbers(node, file, matrix.numbers);
    return matrix;
  }
  const cv::FileNode data = node["data"], type = node["dt"];
  if (node["rows"].empty() || data.empty()) fail(file, node.name() + " is not a matrix");
  if (type.isString() && std::string(type).size() != 1) fail(file, node.name() + " has channels");
  matrix.rows = static_cast<int>(node["rows"]);
  matrix.cols = static_cast<int>(node["cols"]);
  append_numbers(data, file, matrix.numbers);
  if (matrix.numbers.size() != static_cast<std::size_t>(matrix.rows) * matrix.cols) {
    fail(file, node.name() + " has another number of elements than rows and columns say");
  }
  return matrix;
}

int read_side(const cv::FileNode& node, const path& file) {
  if (!node.isInt() || static_cast<int>(node) < 1) {
    fail(file, "image_width and image_height must both be positive whole numbers");
  }
  return static_cast<int>(node);
}

// Kalibr: "cam0: {camera_model, intrinsics: [fx fy cx cy], distortion_model, distortion_coeffs,
// resolution}".
CalibrationNumbers read_kalibr(const cv::FileNode& root, const path& file) {
  if (!root["cam1"].empty()) fail(file, "is a Kalibr file of several cameras; keep one of them");
  const cv::FileNode camera = root["cam0"];
  const auto text = [&](const char* name) {
    const cv::FileNode node = camera[name];
    return node.isString() ? std::string(node) : std::string("none");
  };
  if (text("camera_model") != "pinhole" || text("distortion_model") != "radtan") {
    fail(file, "is a Kalibr file of model " + text("camera_model") + "-" +
                   text("distortion_model") + "; only pinhole-radtan is supported");
  }
  const auto k = read_matrix(camera["intrinsics"], file).numbers;
  if (k.size() != 4) fail(file, "is a Kalibr file without 4 intrinsics");
  CalibrationNumbers read;
  read.matrix = {k[0], 0, k[2], 0, k[1], k[3], 0, 0, 1};
  read.distortion = read_matrix(camera["distortion_coeffs"], file).numbers;
  if (read.distortion.size() != 4) fail(file, "is a Kalibr file without 4 distortion_coeffs");
  const cv::FileNode size = camera["resolution"];
  if (size.isSeq() && size.size() == 2) {
    read.width = read_side(size[0], file);
    read.height = read_side(size[1], file);
  }
  return read;
}

void check_model(const cv::FileNode& root, const path& file) {
  const cv::FileNode fisheye = root["fisheye_model"];
  if (fisheye.isInt() && static_cast<int>(fisheye) != 0) {
    fail(file, "the fisheye lens model is not supported");
  }
  const cv::FileNode model = root["distortion_model"];  // ROS
  if (!model.isString()) return;
  const std::string name = model;
  if (name != "plumb_bob" && name != "rational_polynomial" && !name.empty()) {
    fail(file, "is a ROS camera_info file with the distortion model " + name +
                   "; only plumb_bob and rational_polynomial are supported");
  }
}

CalibrationNumbers read_flat(const cv::FileNode& root, const path& file) {
  check_model(root, file);
  static const std::vector<const char*> kMatrix{"camera_matrix",
                                                "cameraMatrix",
                                                "Camera_Matrix",
                                                "camera_Matrix",
                                                "CameraMatrix",
                                                "intrinsic_matrix",
                                                "mtx",
                                                "K",
                                                "k"};
  static const std::vector<const char*> kDistortion{"distortion_coefficients",
                                                    "Distortion_Coefficients",
                                                    "distortion_coeffs",
                                                    "distCoeffs",
                                                    "dist_coeffs",
                                                    "dist_coeff",
                                                    "distCoeff",
                                                    "dist_coefs",
                                                    "dist",
                                                    "D",
                                                    "d"};
  const cv::FileNode matrix_node = find(root, kMatrix), distortion_node = find(root, kDistortion);
  if (matrix_node.empty()) {
    std::string keys;
    for (const std::string& key : root.keys()) keys += (keys.empty() ? "" : ", ") + key;
    fail(file, "has no camera_matrix (cameraMatrix, K, ...); it has " + keys.substr(0, 200));
  }
  if (distortion_node.empty()) {
    fail(file, "has no distortion_coefficients (distCoeffs, dist_coeff, D, ...)");
  }
  const Matrix matrix = read_matrix(matrix_node, file);
  if (matrix.numbers.size() != 9 || (matrix.rows != 0 && matrix.rows != 3)) {
    fail(file,
         matrix_node.name() + " is " +
             (matrix.rows == 0 ? std::to_string(matrix.numbers.size()) + " numbers"
                               : std::to_string(matrix.rows) + "x" + std::to_string(matrix.cols)) +
             " and not 3x3");
  }
  CalibrationNumbers read;
  std::copy(matrix.numbers.begin(), matrix.numbers.end(), read.matrix.begin());
  const Matrix distortion = read_matrix(distortion_node, file);
  if (distortion.rows > 1 && distortion.cols > 1) {
    fail(file, distortion_node.name() + " is not a row or a column");
  }
  read.distortion = distortion.numbers;
  const cv::FileNode width = find(root, {"image_width", "image_Width", "imageWidth", "width"});
  const cv::FileNode height = find(root, {"image_height", "image_Height", "imageHeight", "height"});
  if (!width.empty() || !height.empty()) {
    read.width = read_side(width, file);
    read.height = read_side(height, file);
  }
  return read;
}

// ROS and Kalibr write YAML without the head that OpenCV asks for.
std::string with_head(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool is_json = first != std::string::npos && text[first] == '{';
  if (is_json || text.starts_with("%YAML") || text.starts_with("<?xml")) return text;
  // What rostopic echo prints ends in a line ---, or has further messages behind it.
  const std::size_t begin = text.starts_with("---") ? std::min(text.find('\n'), text.size()) : 0;
  return "%YAML:1.0\n---\n" + text.substr(begin, text.find("\n---", begin) - begin) + "\n";
}

}  // namespace

CalibrationNumbers read_calibration_file(const path& file) {
  const std::string text = tracking::read_small_text("calibration", file);
  const tracking::QuietOpenCv quiet;
  try {
    const cv::FileStorage storage(with_head(text), cv::FileStorage::READ | cv::FileStorage::MEMORY);
    const cv::FileNode root = storage.isOpened() ? storage.root() : cv::FileNode();
    if (!root.isMap()) {
      fail(file, "is no calibration file of OpenCV, ROS (camera_info) or Kalibr");
    }
    return root["cam0"].isMap() ? read_kalibr(root, file) : read_flat(root, file);
  } catch (const cv::Exception& error) {
    fail(file, "is no calibration file of OpenCV, ROS (camera_info) or Kalibr (" +
                   tracking::first_line(error) + ")");
  }
}

}  // namespace amalgam::client
