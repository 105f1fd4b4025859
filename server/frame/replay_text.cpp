#include "frame/replay_text.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <sstream>
#include <vector>

#include "frame/settings_options.h"

namespace amalgam::frame {
namespace {

// A word for a shell: in single quotes if it has special characters.
std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./:,=+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::ostringstream text;
  text << '\'';
  for (const char c : word) {
    if (c == '\'') {
      text << R"('\'')";
    } else {
      text << c;
    }
  }
  text << '\'';
  return text.str();
}

std::string json_array(std::span<const double> numbers) {
  std::ostringstream text;
  const char* separator = "[";
  for (const double number : numbers) {
    text << separator << exact_text(number);
    separator = ",";
  }
  text << "]";
  return text.str();
}
std::string json_array(std::initializer_list<double> numbers) {
  return json_array(std::span(numbers.begin(), numbers.size()));
}

// In the format of load_poses() of amalgam-render.
std::string poses_json(std::span<const common::MarkerPose> poses) {
  std::ostringstream text;
  text << R"({"poses":[)";
  const char* separator = "";
  for (const auto& [marker, r, t] : poses) {
    text << separator << R"({"marker":)" << marker << R"(,"rotation":)"
         << json_array({r.x, r.y, r.z, r.w}) << R"(,"translation":)" << json_array({t.x, t.y, t.z})
         << "}";
    separator = ",";
  }
  text << "]}";
  return text.str();
}

void put_opencv_matrix(std::ostream& text, int rows, int columns, const std::string& data) {
  text << R"({"type_id":"opencv-matrix","rows":)" << rows << R"(,"cols":)" << columns
       << R"(,"dt":"d","data":)" << data << "}";
}

// In the format of OpenCV's FileStorage.
std::string calibration_json(const common::CameraModel& camera) {
  const auto& c = camera;
  std::ostringstream text;
  text << R"({"image_width":)" << c.width << R"(,"image_height":)" << c.height
       << R"(,"camera_matrix":)";
  put_opencv_matrix(text, 3, 3, json_array({c.fx, 0.0, c.cx, 0.0, c.fy, c.cy, 0.0, 0.0, 1.0}));
  text << R"(,"distortion_coefficients":)";
  put_opencv_matrix(text, 1, static_cast<int>(c.distortion.size()), json_array(c.distortion));
  text << "}";
  return text.str();
}

void put_file(std::ostream& text, const std::string& json, const char* name) {
  text << "echo '" << json << "' > " << name << " && ";
}

std::string scene_word(const std::string& path) {
  if (path.empty()) return "<scene>";
  std::error_code ignored;  // the path stays relative
  const auto absolute = std::filesystem::absolute(path, ignored);
  return ignored ? path : absolute.lexically_normal().string();
}

std::vector<std::string> arguments(const ReplayedFrame& frame, bool calibrated) {
  std::vector<std::string> words = {
      "--scene", scene_word(frame.scene_path),
      "--size",  std::to_string(frame.camera.width) + "x" + std::to_string(frame.camera.height),
      "--poses", "poses.json"};
  const auto add = [&](std::initializer_list<std::string> more) {
    words.insert(words.end(), more);
  };
  if (calibrated) add({"--calibration", "calibration.json"});
  const std::vector<std::string> options = settings_options(frame.settings);
  words.insert(words.end(), options.begin(), options.end());
  if (frame.repeat > 1) add({"--repeat", std::to_string(frame.repeat), "--still"});
  if (frame.keep_provenance) add({"--json"});
  if (frame.keep_buffers) add({"--dump", "buffers"});
  return words;
}

}  // namespace

std::string replay_text(const ReplayedFrame& frame) {
  const bool calibrated =
      frame.camera != common::default_camera(frame.camera.width, frame.camera.height);
  std::ostringstream text;
  put_file(text, poses_json(frame.poses), "poses.json");
  if (calibrated) put_file(text, calibration_json(frame.camera), "calibration.json");
  text << "amalgam-render";
  for (const std::string& word : arguments(frame, calibrated)) text << ' ' << quoted(word);
  text << "\n# the camera's picture is not kept; if you have it: --camera-image instead of --size";
  if (frame.environment_replaced) text << "\n# a client had replaced the scene's environment";
  if (const std::string more = settings_without_options(frame.settings); !more.empty()) {
    text << "\n# without an option: " << more;
  }
  return text.str();
}

}  // namespace amalgam::frame
