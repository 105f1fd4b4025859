// amalgam-client: a camera, a connection and a place for the composites.

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <opencv2/core/utils/logger.hpp>
#include <stdexcept>

#include "client/calibrate.h"
#include "client/link/messages.h"
#include "client/options.h"
#include "client/sources/camera_devices.h"
#include "client/sources/capture_source.h"
#include "client/sources/environment_message.h"
#include "client/sources/images_source.h"
#include "client/sources/synthetic_source.h"
#include "client/summary.h"
#include "client/tracking/calibration.h"
#include "common/log.h"
#include "common/run_program.h"
#include "common/token_file.h"
#include "protocol/framing.h"
#include "protocol/limits.h"

namespace amalgam::client {
namespace {

std::atomic<bool> stop_requested = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // set from a signal handler

const cv::Size kSyntheticSize{800, 600};

common::CameraModel camera_for(const Options& options, cv::Size size) {
  if (!options.calibration.empty()) {
    return fit_to_image(load_calibration(options.calibration), size.width, size.height);
  }
  if (options.field_of_view) {
    return common::camera_of_view(size.width, size.height, *options.field_of_view);
  }
  if (!options.synthetic) {
    common::log_warn(
        "neither --calibration nor --fov: a 60 degrees wide lens is assumed, positions will be "
        "off");
  }
  return common::default_camera(size.width, size.height);
}

std::unique_ptr<CameraSource> make_source(const Options& options) {
  const int quality = options.camera_quality;
  if (options.camera) {
    return std::make_unique<CaptureSource>(
        CaptureSource::device(*options.camera, options.size, quality));
  }
  if (!options.video.empty()) {
    return std::make_unique<CaptureSource>(
        CaptureSource::film(options.video, options.size, quality));
  }
  if (!options.images.empty()) {
    return std::make_unique<ImagesSource>(ImagesOptions{.patterns = options.images,
                                                        .size = options.size,
                                                        .jpeg_quality = quality,
                                                        .repeat = options.repeat_images});
  }
  const cv::Size size = options.size.empty() ? kSyntheticSize : options.size;
  return std::make_unique<SyntheticSource>(
      camera_for(options, size), options.true_poses, quality,
      options.synthetic_mirror ? std::optional(DeskMirror()) : std::nullopt);
}

std::unique_ptr<FrameSink> make_sink(const Options& options) {
  if (options.display) return make_display_sink();
  if (!options.record.empty()) return make_record_sink(options.record, options.viewer.rate);
  if (!options.output.empty()) return make_folder_sink(options.output);
  return nullptr;
}

int list_cameras() {
  const std::vector<CameraDevice> cameras = find_cameras();
  if (cameras.empty()) throw std::runtime_error("there is no camera");
  for (const CameraDevice& camera : cameras) {
    std::printf("%d  %s\n", camera.number, camera.name.c_str());
  }
  return EXIT_SUCCESS;
}

int run(const Options& options) {
  common::set_log_level(options.log_level);
  if (options.list_cameras) return list_cameras();
  const std::string token =
      options.token_file.empty()
          ? std::string()
          : common::read_token_file(options.token_file, protocol::kMaxTokenBytes);
  const auto sink = make_sink(options);
  const auto source = make_source(options);
  if (!options.calibrate.empty()) {
    calibrate(options, *source, sink.get(), stop_requested);
    return EXIT_SUCCESS;
  }
  const common::CameraModel camera =
      source->own_camera() ? *source->own_camera() : camera_for(options, source->size());
  ConnectionOptions connection_options = options.connection;
  if (!options.environment.empty()) {
    protocol::Envelope message = load_environment(options.environment, options.environment_fisheye);
    message.mutable_environment()->set_own(options.own_environment);
    connection_options.after_welcome = protocol::encode(message);
  }
  Connection connection(connection_options,
                        hello_message(camera, token, options.composite_quality));
  Viewer viewer(options.viewer, camera, *source, sink.get(), connection, stop_requested);
  const ViewerSummary summary = viewer.run();
  if (summary.frames.captured > 0 || !summary.gave_up) {
    const std::string text = options.json ? summary_json(summary) + "\n" : summary_text(summary);
    std::fputs(text.c_str(), stdout);
  }
  if (summary.gave_up) throw std::runtime_error(summary.last_error);
  if (summary.frames.captured > 0 && summary.frames.composited == 0) {
    throw std::runtime_error("no frame was composited" + (summary.last_error.empty()
                                                              ? std::string()
                                                              : ": " + summary.last_error));
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace amalgam::client

int main(int argc, char** argv) {
  using namespace amalgam::client;
  return amalgam::common::run_program("amalgam-client", [&] {
    // Complaints of video backends that were merely tried would hide the one line that matters.
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    const auto options = parse_options(argc, argv);
    if (!options) return EXIT_SUCCESS;
    const auto request_stop = [](int) { stop_requested = true; };
    std::signal(SIGINT, request_stop);
    std::signal(SIGTERM, request_stop);
    return run(*options);
  });
}
