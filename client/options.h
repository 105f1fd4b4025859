// The command line of amalgam-client.
#pragma once

#include <opencv2/core/types.hpp>
#include <optional>
#include <string>
#include <vector>

#include "client/link/connection.h"
#include "client/viewer.h"

namespace amalgam::client {

struct Options {
  ConnectionOptions connection;
  std::string token_file;
  int composite_quality = 0;  // 0: the server's default
  int camera_quality = 92;

  std::optional<int> camera;
  std::string video;
  std::vector<std::string> images;
  bool repeat_images = false;
  std::string calibrate;                    // file to write; instead of talking to a server
  std::string dictionary = "DICT_6X6_250";  // of the board that calibrates
  bool list_cameras = false;                // and nothing else
  bool synthetic = false;
  bool synthetic_mirror = false;
  bool true_poses = false;
  cv::Size size;  // empty: the source's own
  std::string calibration;
  std::optional<double> field_of_view;  // degrees, of the width; instead of a calibration
  std::string environment, environment_fisheye;
  bool own_environment = false;

  bool display = false;
  std::string record;
  std::string output;

  ViewerOptions viewer;
  bool json = false;
  std::string log_level = "warn";
};

// Nothing if the program is to end, because help or version was asked for and is on standard
// output. Throws std::runtime_error or std::invalid_argument with one line for a mistake.
std::optional<Options> parse_options(int argc, const char* const* argv);

// "host:port" or "[address]:port", port not 0. Throws std::runtime_error.
common::HostPort parse_server(const std::string& text);

// "MINCUTOFF[:BETA]" of a One-Euro filter. Throws std::runtime_error.
tracking::OneEuroOptions parse_smoothing(const std::string& text);

// "800x600" in pixels. Throws std::runtime_error.
cv::Size parse_size(const std::string& text);

}  // namespace amalgam::client
