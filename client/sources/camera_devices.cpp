#include "client/sources/camera_devices.h"

#include <algorithm>
#include <charconv>
#include <fstream>

namespace amalgam::client {
namespace {

std::string first_line(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

}  // namespace

std::vector<CameraDevice> find_cameras(const std::filesystem::path& devices) {
  constexpr std::string_view kPrefix = "video";
  std::vector<CameraDevice> cameras;
  std::error_code failed;  // a machine without cameras has no such folder
  for (const auto& entry : std::filesystem::directory_iterator(devices, failed)) {
    const std::string device = entry.path().filename().string();
    if (!device.starts_with(kPrefix)) continue;
    CameraDevice camera;
    const char* const end = device.data() + device.size();
    const auto result = std::from_chars(device.data() + kPrefix.size(), end, camera.number);
    if (result.ec != std::errc() || result.ptr != end) continue;
    // The picture is the first of a camera's devices.
    if (const std::string index = first_line(entry.path() / "index");
        !index.empty() && index != "0") {
      continue;
    }
    camera.name = first_line(entry.path() / "name");
    cameras.push_back(std::move(camera));
  }
  std::ranges::sort(cameras, {}, &CameraDevice::number);
  return cameras;
}

}  // namespace amalgam::client
