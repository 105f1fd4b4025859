#include "client/tracking/calibration_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>

#include "client/tracking/calibration.h"
#include "support/test_data.h"

// One camera, as everybody writes it.

namespace amalgam::client {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::filesystem::path file_with(const std::string& text, const std::string& extension = ".yaml") {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file = std::filesystem::path(testing::TempDir()) /
                    ("calibration_file_" + std::string(test->name()) + extension);
  std::ofstream(file) << text;
  return file;
}

std::string error_of(const std::string& text) {
  try {
    load_calibration(file_with(text));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

void expect_camera(const std::filesystem::path& file, bool has_size = true) {
  const CalibrationNumbers read = read_calibration_file(file);
  EXPECT_THAT(read.matrix, ElementsAre(600, 0, 319.5, 0, 610, 239.5, 0, 0, 1)) << file;
  ASSERT_GE(read.distortion.size(), 4u) << file;
  EXPECT_THAT(std::vector(read.distortion.begin(), read.distortion.begin() + 4),
              ElementsAre(0.01, -0.02, 0.003, 0.004))
      << file;
  EXPECT_EQ(read.width, has_size ? 640 : 0) << file;
  EXPECT_EQ(read.height, has_size ? 480 : 0) << file;
}

const std::string kRos =
    "image_width: 640\nimage_height: 480\ncamera_name: narrow_stereo\n"
    "camera_matrix:\n  rows: 3\n  cols: 3\n"
    "  data: [600, 0, 319.5, 0, 610, 239.5, 0, 0, 1]\n"
    "distortion_model: plumb_bob\n"
    "distortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [0.01, -0.02, 0.003, 0.004, 0]\n"
    "projection_matrix:\n  rows: 3\n  cols: 4\n  data: [600, 0, 319.5, 0, 0, 610, 239.5, 0, 0, 0, "
    "1, 0]\n";

TEST(CalibrationFile, Ros) {
  expect_camera(file_with(kRos));
  expect_camera(file_with("---\n" + kRos));
  expect_camera(file_with("%YAML:1.0\n---\n" + kRos));
}

// As rostopic echo prints them, one (-n1) or several.
TEST(CalibrationFile, RosMessagesThatWerePrinted) {
  expect_camera(file_with(kRos + "---\n"));
  expect_camera(file_with(kRos + "---\n" + kRos + "---\n"));
  expect_camera(file_with("---\n" + kRos + "---\n"));
  EXPECT_THAT(error_of("---"), HasSubstr("is no calibration file"));
  EXPECT_THAT(error_of("---\n---\n"), HasSubstr("is no calibration file"));
}

TEST(CalibrationFile, RosMessages) {
  for (const bool upper : {true, false}) {
    const std::string k = upper ? "K" : "k", d = upper ? "D" : "d";
    expect_camera(
        file_with("header:\n  seq: 1\n  frame_id: \"camera\"\nheight: 480\nwidth: 640\n"
                  "distortion_model: \"plumb_bob\"\n" +
                  d + ": [0.01, -0.02, 0.003, 0.004, 0.0]\n" + k +
                  ": [600.0, 0.0, 319.5, 0.0, 610.0, 239.5, 0.0, 0.0, 1.0]\n"));
  }
}

TEST(CalibrationFile, Kalibr) {
  const std::string text =
      "cam0:\n  cam_overlaps: [1]\n  camera_model: pinhole\n"
      "  distortion_coeffs: [0.01, -0.02, 0.003, 0.004]\n  distortion_model: radtan\n"
      "  intrinsics: [600.0, 610.0, 319.5, 239.5]\n  resolution: [640, 480]\n"
      "  rostopic: /cam0/image_raw\n";
  expect_camera(file_with(text));
  std::string fisheye = text;
  fisheye.replace(fisheye.find("radtan"), 6, "equidistant");
  EXPECT_THAT(error_of(fisheye), HasSubstr("a Kalibr file of model pinhole-equidistant"));
  std::string second = text;
  EXPECT_THAT(error_of(text + second.replace(0, 4, "cam1")), HasSubstr("several cameras"));
}

TEST(CalibrationFile, OpenCvInThreeLanguages) {
  const cv::Mat k = (cv::Mat_<double>(3, 3) << 600, 0, 319.5, 0, 610, 239.5, 0, 0, 1);
  const cv::Mat d = (cv::Mat_<double>(5, 1) << 0.01, -0.02, 0.003, 0.004, 0.0);
  for (const char* extension : {".yml", ".xml", ".json"}) {
    const auto file = file_with("", extension);
    cv::FileStorage storage(file.string(), cv::FileStorage::WRITE);
    storage << "image_width" << 640 << "image_height" << 480 << "camera_matrix" << k
            << "distortion_coefficients" << d;
    storage.release();
    expect_camera(file);
  }
}

TEST(CalibrationFile, OtherNames) {
  for (const auto& [matrix, distortion] : {std::pair("cameraMatrix", "distCoeffs"),
                                           {"camera_matrix", "dist_coeff"},
                                           {"Camera_Matrix", "Distortion_Coefficients"},
                                           {"mtx", "dist"}}) {
    expect_camera(file_with(std::string("{\"") + matrix +
                            "\": [[600, 0, 319.5], [0, 610, 239.5], [0, 0, 1]], \"" + distortion +
                            "\": [[0.01, -0.02, 0.003, 0.004, 0.0]]}"),
                  false);
  }
}

TEST(CalibrationFile, ErrorsNameWhatWasMet) {
  EXPECT_THAT(error_of("focal: 3\nlens: wide\n"), HasSubstr("it has focal, lens"));
  EXPECT_THAT(error_of("camera_matrix: [1, 2, 3]\nD: [0, 0, 0, 0]\n"),
              HasSubstr("camera_matrix is 3 numbers and not 3x3"));
  std::string fisheye = kRos;
  fisheye.replace(fisheye.find("plumb_bob"), 9, "equidistant");
  EXPECT_THAT(error_of(fisheye),
              HasSubstr("a ROS camera_info file with the distortion model equid"));
  EXPECT_THAT(error_of("camera_matrix: [a, b]\nD: [0]\n"), HasSubstr("'a' where a number"));
  std::string wrong = kRos;
  wrong.replace(wrong.find("cols: 5"), 7, "cols: 4");
  EXPECT_THAT(error_of(wrong), HasSubstr("another number of elements"));
}

TEST(CalibrationFile, ReportedFiles) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  for (const char* name : {"ros.yaml", "cameraMatrix.yml", "distcoeff.yml"}) {
    const auto camera = load_calibration(*data / "reports/ros-camera-info" / name);
    EXPECT_EQ(camera.fx, 600.0) << name;
    EXPECT_EQ(camera.cy, 239.5) << name;
    EXPECT_EQ(camera.distortion[0], 0.01) << name;
    EXPECT_EQ(camera.distortion[1], -0.02) << name;
  }
}

}  // namespace
}  // namespace amalgam::client
