#include "report/picture_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bench/picture_error.h"
#include "report/worst_pictures.h"

namespace amalgam::report {
namespace {

common::ImageRgb32f grey(float value) {
  return common::ImageRgb32f(16, 16, glm::vec3(value));
}

TEST(PictureFigures, OfTheSamePicture) {
  const PictureFigures figures = picture_figures(grey(0.5f), grey(0.5f));
  EXPECT_EQ(figures.mae, 0.0);
  EXPECT_EQ(figures.mse, 0.0);
  EXPECT_EQ(figures.mrse, 0.0);
  EXPECT_NEAR(figures.ssim, 1.0, 1e-12);
  EXPECT_TRUE(std::isinf(figures.psnr));
  EXPECT_EQ(figures.maximum, 0.0);
  EXPECT_EQ(figures.nonfinite, 0u);
}

// One channel of one of 256 pixels is off by 1/4.
TEST(PictureFigures, ClosedForms) {
  common::ImageRgb32f actual = grey(0.5f);
  actual.at(3, 5).g = 0.25f;
  const PictureFigures figures = picture_figures(actual, grey(0.5f));
  constexpr double kValues = 3 * 256;
  EXPECT_NEAR(figures.mae, 0.25 / kValues, 1e-15);
  EXPECT_NEAR(figures.mse, 0.0625 / kValues, 1e-15);
  EXPECT_NEAR(figures.mrse, 0.0625 / (0.51 * 0.51) / kValues, 1e-15);
  EXPECT_EQ(figures.maximum, 0.25);
  EXPECT_LT(figures.ssim, 1.0);
}

// PSNR is 10 lg(255^2 / mean square difference), of the bytes.
TEST(PictureFigures, PsnrIsThatOfBytes) {
  const common::ImageRgb8 a(16, 16, common::Rgb8(100)), b(16, 16, common::Rgb8(110));
  EXPECT_NEAR(bench::psnr(a, b), 10.0 * std::log10(255.0 * 255.0 / 100.0), 1e-6);
  EXPECT_NEAR(picture_figures(as_light(a), as_light(b)).psnr, bench::psnr(a, b), 1e-6);
}

TEST(PictureFigures, WhatIsNotFiniteCannotHide) {
  common::ImageRgb32f actual = grey(0.25f);
  actual.at(0, 0).r = std::numeric_limits<float>::quiet_NaN();
  actual.at(1, 0).b = std::numeric_limits<float>::infinity();
  const PictureFigures figures = picture_figures(actual, grey(0.25f));
  EXPECT_EQ(figures.nonfinite, 2u);
  EXPECT_EQ(figures.maximum, 0.75);
  EXPECT_NEAR(figures.mae, 2.0 * 0.75 / (3 * 256), 1e-15);
  EXPECT_EQ(difference_picture(actual, grey(0.25f)).at(0, 0), common::Rgb8(255));
}

TEST(PictureFigures, SizesMustBeEqual) {
  EXPECT_THROW(picture_figures(grey(0.5f), common::ImageRgb32f(16, 15)), std::invalid_argument);
}

TEST(PictureFigures, BytesSurviveLight) {
  common::ImageRgb8 bytes(256, 1);
  for (int i = 0; i < 256; ++i) bytes.at(i, 0) = common::Rgb8(i, 255 - i, 7);
  EXPECT_EQ(as_bytes(as_light(bytes)), bytes);
}

TEST(PictureFigures, TheDifferenceIsTenfold) {
  const common::ImageRgb8 picture = difference_picture(grey(0.5f), grey(0.52f));
  const common::ImageRgb8 expected = as_bytes(grey(0.2f));
  EXPECT_NEAR(picture.at(7, 7).r, expected.at(7, 7).r, 1);
}

}  // namespace
}  // namespace amalgam::report
