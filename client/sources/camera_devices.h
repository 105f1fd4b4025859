// The cameras of this machine, as Linux names them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace amalgam::client {

struct CameraDevice {
  int number = 0;  // for --camera
  std::string name;
};

// By ascending number. A camera has further devices for what is no picture; these are left out.
std::vector<CameraDevice> find_cameras(
    const std::filesystem::path& devices = "/sys/class/video4linux");

}  // namespace amalgam::client
