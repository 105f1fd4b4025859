// The kinds of files in which people keep a pinhole camera's calibration, as one list of numbers.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

namespace amalgam::client {

struct CalibrationNumbers {
  std::array<double, 9> matrix{};  // row by row
  std::vector<double> distortion;  // in OpenCV's order: k1 k2 p1 p2 k3 ...
  int width = 0, height = 0;       // pixels; 0 if the file does not say
};

// Reads files of OpenCV (YAML, XML, JSON), with the names of its own programs and of the usual
// samples; ROS's camera_info (calibration files, and messages); Kalibr's camchain of one pinhole
// camera with radtan distortion. Throws std::runtime_error with one line that names the kind of
// file that it met.
CalibrationNumbers read_calibration_file(const std::filesystem::path& file);

}  // namespace amalgam::client
