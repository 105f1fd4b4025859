// The pictures that a failing test writes for inspection.
#pragma once

#include <filesystem>
#include <string>

#include "common/image.h"

namespace amalgam::test_support {

// test_output/SUITE.TEST in the build folder, of the running test; '/' in its name becomes '_'. The
// folder may not exist.
std::filesystem::path test_output_folder();

// Writes NAME-expected, NAME-actual and NAME-difference to test_output_folder(), each as .exr,
// which has the numbers, and as .png, for any viewer. EXR: the difference is actual - expected.
// PNG: white is the largest value of both pictures; of the difference's absolute value, white is
// white_difference, or its largest value if that is 0. What is not finite is magenta.
// Returns a line for each PNG, with its path.
std::string write_test_output(const std::string& name, const common::ImageRgb32f& actual,
                              const common::ImageRgb32f& expected, double white_difference = 0.0);

// Removes those files of an earlier run.
void remove_test_output(const std::string& name);

}  // namespace amalgam::test_support
