#include "client/tracking/calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "common/camera_model.h"
#include "support/test_data.h"

namespace amalgam::client {
namespace {

using testing::HasSubstr;

std::filesystem::path write_file(const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / (std::string(test->name()) + ".yml");
  std::ofstream(file) << text;
  return file;
}

std::string matrix(int rows, int cols, const std::string& data) {
  return "!!opencv-matrix\n   rows: " + std::to_string(rows) +
         "\n   cols: " + std::to_string(cols) + "\n   dt: d\n   data: [ " + data + " ]\n";
}

const std::string kHead = "%YAML:1.0\n";
const std::string kCamera =
    "camera_matrix: " + matrix(3, 3, "600., 0., 320., 0., 610., 240., 0., 0., 1.");
const std::string kNoDistortion = "distortion_coefficients: " + matrix(1, 4, "0., 0., 0., 0.");

std::string error_of(const std::string& text) {
  try {
    load_calibration(write_file(text));
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "more than one line";
    return error.what();
  }
  return "no error";
}

TEST(Calibration, ReadsIntrinsicsDistortionAndSize) {
  const auto camera = load_calibration(
      write_file(kHead + "---\nimage_width: 640\nimage_height: 480\n" + kCamera +
                 "distortion_coefficients: " + matrix(5, 1, "0.1, -0.2, 0.003, 0.004, 0.05")));
  EXPECT_EQ(camera.width, 640);
  EXPECT_EQ(camera.height, 480);
  EXPECT_EQ(camera.fx, 600.0);
  EXPECT_EQ(camera.fy, 610.0);
  EXPECT_EQ(camera.cx, 320.0);
  EXPECT_EQ(camera.cy, 240.0);
  const std::array<double, 12> expected{0.1, -0.2, 0.003, 0.004, 0.05};
  EXPECT_EQ(camera.distortion, expected);
}

TEST(Calibration, WithoutSizeTakesTheImages) {
  const auto calibration = load_calibration(write_file(kHead + kCamera + kNoDistortion));
  EXPECT_EQ(calibration.width, 0);
  const auto camera = fit_to_image(calibration, 640, 480);
  EXPECT_EQ(camera.width, 640);
  EXPECT_EQ(camera.height, 480);
  EXPECT_EQ(camera.cx, 320.0);
}

TEST(Calibration, AcceptsTiltCoefficientsOnlyAsZero) {
  const std::string twelve = "0.1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0";
  EXPECT_NO_THROW(load_calibration(write_file(
      kHead + kCamera + "distortion_coefficients: " + matrix(1, 14, twelve + ", 0., 0."))));
  EXPECT_THAT(error_of(kHead + kCamera +
                       "distortion_coefficients: " + matrix(1, 14, twelve + ", 0.01, 0.")),
              HasSubstr("tilted"));
}

TEST(Calibration, SaysWhatIsWrongWithAFile) {
  EXPECT_THAT(error_of(""), HasSubstr("empty"));
  EXPECT_THAT(error_of("not a calibration"), HasSubstr("no calibration file of OpenCV, ROS"));
  EXPECT_THAT(error_of(kHead + "camera_matrix: [1, 2\n"),
              HasSubstr("no calibration file of OpenCV, ROS"));
  EXPECT_THAT(error_of(kHead + kNoDistortion), HasSubstr("no camera_matrix"));
  EXPECT_THAT(error_of(kHead + kCamera), HasSubstr("no distortion_coefficients"));
  EXPECT_THAT(error_of(kHead + "camera_matrix: " + matrix(2, 2, "1., 0., 0., 1.") + kNoDistortion),
              HasSubstr("2x2"));
  EXPECT_THAT(error_of(kHead + "camera_matrix: " +
                       matrix(3, 3, "0., 0., 320., 0., 0., 240., 0., 0., 1.") + kNoDistortion),
              HasSubstr("focal"));
  EXPECT_THAT(error_of(kHead + "camera_matrix: " +
                       matrix(3, 3, ".Nan, 0., 320., 0., 600., 240., 0., 0., 1.") + kNoDistortion),
              HasSubstr("finite"));
  EXPECT_THAT(error_of(kHead + "camera_matrix: " +
                       matrix(3, 3, "600., 5., 320., 0., 600., 240., 0., 0., 1.") + kNoDistortion),
              HasSubstr("skew"));
  EXPECT_THAT(error_of(kHead + "camera_matrix: " +
                       matrix(3, 3, "600., 0., 0., 0., 600., 0., 320., 240., 1.") + kNoDistortion),
              HasSubstr("form"));
  EXPECT_THAT(error_of(kHead + "image_width: 640\nimage_height: -2\n" + kCamera + kNoDistortion),
              HasSubstr("image_width"));
  EXPECT_THAT(error_of(kHead + "fisheye_model: 1\n" + kCamera + kNoDistortion),
              HasSubstr("fisheye"));
  EXPECT_THAT(error_of(kHead + "image_width: 640\nimage_height: 480\n" + kCamera +
                       "distortion_coefficients: " + matrix(1, 4, "-3., 0., 0., 0.")),
              HasSubstr("cannot be inverted"));
  EXPECT_THROW(load_calibration("no/such/file.yml"), std::runtime_error);
  EXPECT_THROW(load_calibration(testing::TempDir()), std::runtime_error);
}

TEST(Calibration, ScalesToTheSameViewInAnotherSize) {
  common::CameraModel camera = common::default_camera(640, 480);
  camera.cx = 300.0;
  const auto half = fit_to_image(camera, 320, 240);
  // The same direction is seen at the same place of the picture, measured from its corner.
  const auto whole_pixel = common::project(camera, {0.1, 0.2, 1.0});
  const auto half_pixel = common::project(half, {0.1, 0.2, 1.0});
  ASSERT_TRUE(whole_pixel && half_pixel);
  EXPECT_NEAR((whole_pixel->x + 0.5) / 2, half_pixel->x + 0.5, 1e-12);
  EXPECT_NEAR((whole_pixel->y + 0.5) / 2, half_pixel->y + 0.5, 1e-12);
  EXPECT_THROW(fit_to_image(camera, 640, 400), std::runtime_error);
}

TEST(Calibration, RefusesAnImageThatDoesNotHoldThePrincipalPoint) {
  const auto calibration = load_calibration(write_file(kHead + kCamera + kNoDistortion));
  EXPECT_THROW(fit_to_image(calibration, 160, 120), std::runtime_error);
}

TEST(Calibration, DefaultIsSixtyDegreesWide) {
  const auto camera = common::default_camera(800, 600);
  EXPECT_EQ(common::describe_defect(camera), "");
  // The image's left edge, half a pixel before the first pixel's centre, is 30 degrees off.
  EXPECT_NEAR((-0.5 - camera.cx) / camera.fx, -std::tan(std::acos(-1.0) / 6), 1e-12);
}

TEST(Calibration, ReadsTheTutorialFiles) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "no test data (AMALGAM_TEST_DATA or ../shared/data)";
  const auto folder = *data / "real_markers" / "opencv_contrib";
  const auto params =
      fit_to_image(load_calibration(folder / "tutorial_camera_params.yml"), 640, 480);
  EXPECT_EQ(params.fx, 628.158);
  EXPECT_EQ(params.cy, 260.908);
  EXPECT_EQ(params.distortion[3], 0.00336531);
  // Its numbers are wrapped four to a line, but it is a 3x3 matrix like any other.
  const auto charuco = load_calibration(folder / "tutorial_camera_charuco.yml");
  EXPECT_EQ(charuco.width, 640);
  EXPECT_EQ(charuco.fy, 4.5676707935146891e+02);
  EXPECT_EQ(charuco.cy, 2.7775155919135995e+02);
  EXPECT_EQ(charuco.distortion[4], 2.9542589406810080e+00);
}

}  // namespace
}  // namespace amalgam::client
