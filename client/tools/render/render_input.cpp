#include "client/tools/render/render_input.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <span>
#include <stdexcept>

#include "client/tracking/calibration.h"
#include "client/tracking/marker_tracker.h"
#include "client/tracking/poses_file.h"
#include "codec/jpeg.h"
#include "common/whole_file.h"
#include "frame/default_view.h"
#include "scene/marker_ids.h"
#include "tracking/marker_dictionary.h"

namespace amalgam::tools {
namespace {

frame::Bytes read_picture(const std::filesystem::path& path) {
  const std::string file = common::read_whole_file(path, common::kMostPictureBytes);
  const auto bytes = std::as_bytes(std::span(file));
  return {bytes.begin(), bytes.end()};
}

// An empty picture if the bytes are none.
cv::Mat decode(frame::Bytes& bytes) {
  if (bytes.empty()) return {};
  const cv::Mat view(1, static_cast<int>(bytes.size()), CV_8UC1, bytes.data());
  return cv::imdecode(view, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
}

bool is_camera_jpeg(const frame::Bytes& bytes) {
  try {
    codec::read_jpeg_header(bytes);
    return true;
  } catch (const codec::JpegError&) {
    return false;  // another format, or a JPEG that a camera would not send
  }
}

// Any picture that OpenCV reads. A baseline JPEG keeps its bytes, as a client would send them.
void load_image(const std::filesystem::path& path, frame::FrameInput& frame, cv::Mat& bgr) {
  frame::Bytes bytes = read_picture(path);
  bgr = decode(bytes);
  if (bgr.empty()) throw std::runtime_error(path.string() + ": not a picture");
  if (is_camera_jpeg(bytes)) {
    frame.image = std::move(bytes);
    return;
  }
  common::ImageRgb8 pixels(bgr.cols, bgr.rows);
  cv::Mat rgb(bgr.rows, bgr.cols, CV_8UC3, pixels.data());
  cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
  frame.image = std::move(pixels);
}

std::vector<common::MarkerPose> detect(const cv::Mat& bgr, const common::CameraModel& camera,
                                       const scene::Scene& scene) {
  client::TrackerOptions options;
  options.dictionary = tracking::predefined_dictionary(scene.world.dictionary);
  options.marker_length = scene.world.marker_length;
  return client::MarkerTracker(options, camera).track(bgr);
}

}  // namespace

std::string describe_missing_markers(const RenderInput& input, const scene::Scene& scene) {
  const std::vector<int> wanted = scene::marker_ids(scene);
  std::string found;
  for (const common::MarkerPose& pose : input.frame.poses) {
    if (std::find(wanted.begin(), wanted.end(), pose.marker) != wanted.end()) return "";
    found += (found.empty() ? "" : ", ") + std::to_string(pose.marker);
  }
  if (found.empty() && input.detected)
    return "no marker of " + scene.world.dictionary + " found in the image";
  return "no marker of the scene among the poses (" + (found.empty() ? "none" : found) +
         "): its world_marker is " + std::to_string(wanted.front());
}

RenderInput load_render_input(const RenderInputOptions& options, const scene::Scene& scene) {
  RenderInput input;
  cv::Mat bgr;
  int width = options.width, height = options.height;
  if (options.camera_image) {
    load_image(*options.camera_image, input.frame, bgr);
    width = bgr.cols;
    height = bgr.rows;
  } else {
    input.frame.image = common::ImageRgb8(width, height, common::Rgb8(128));
  }
  input.camera =
      options.calibration
          ? client::fit_to_image(client::load_calibration(*options.calibration), width, height)
          : common::default_camera(width, height);
  if (options.poses) {
    input.frame.poses = client::load_poses(*options.poses);
  } else if (options.camera_image) {
    input.frame.poses = detect(bgr, input.camera, scene);
    input.detected = true;
  } else {
    input.frame.poses = {frame::default_pose(scene.world.marker)};
  }
  return input;
}

}  // namespace amalgam::tools
