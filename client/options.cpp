#include "client/options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <stdexcept>

#include "client/tracking/board_description.h"
#include "common/build_info.h"
#include "common/image_size.h"
#include "common/parse_command_line.h"
#include "protocol/limits.h"

namespace amalgam::client {
namespace {

struct BoardTexts {
  std::string file, grid, charuco;
};

std::optional<tracking::MarkerBoard> read_board(const BoardTexts& texts) {
  if (!texts.file.empty()) return load_board(texts.file);
  if (!texts.grid.empty()) return parse_grid_board(texts.grid);
  if (!texts.charuco.empty()) return parse_charuco_board(texts.charuco);
  return std::nullopt;
}

// Turns what a parser throws into CLI11's complaint about the option.
template <typename Parser>
CLI::Validator checked_by(Parser parser) {
  return CLI::Validator(
      [parser](const std::string& text) -> std::string {
        try {
          parser(text);
          return {};
        } catch (const std::runtime_error& error) {
          return error.what();
        }
      },
      {});
}

void add_markers(CLI::App& app, BoardTexts& board, std::string& smoothing, double& dead_band) {
  auto* group = app.add_option_group(
      "board",
      "at most one of; its pose is sent as the world marker's. If the world marker is one "
      "of the board's, that lies at its own place, otherwise in the board's middle or "
      "where the file has its origin");
  group
      ->add_option("--board", board.file,
                   "layout of markers that are fixed to one another (.yml, .json)")
      ->type_name("FILE");
  group
      ->add_option("--grid", board.grid,
                   "OpenCV's grid board: markers along both sides, marker and gap in metres")
      ->type_name("CxR:MARKER:GAP[:FIRST_ID]")
      ->check(checked_by(parse_grid_board));
  group
      ->add_option("--charuco", board.charuco,
                   "OpenCV's ChArUco board: squares along both sides, square and marker in metres")
      ->type_name("CxR:SQUARE:MARKER[:FIRST_ID]")
      ->check(checked_by(parse_charuco_board));
  group->require_option(0, 1);
  app.add_option("--smooth", smoothing,
                 "One-Euro smoothing of poses: cut-off at rest in Hz, and by how many Hz it rises "
                 "for each m/s and each rad/s (default 0)")
      ->type_name("MINCUTOFF[:BETA]")
      ->check(checked_by(parse_smoothing));
  app.add_option("--dead-band", dead_band,
                 "send a marker's last pose again while the new one would move nothing on it by "
                 "more than so many pixels: on a tripod objects stand still, and frames cost the "
                 "server a tenth")
      ->type_name("PIXELS")
      ->check(common::in_range(0.0, 100.0))
      ->default_str("0: off");
}

void add_source(CLI::App& app, Options& options) {
  auto* source = app.add_option_group("source", "exactly one of");
  source->add_option("--camera", options.camera, "camera device number")
      ->type_name("N")
      ->check(common::in_range(0, 1000));
  source->add_option("--video", options.video, "film file")->type_name("FILE");
  source
      ->add_option("--images", options.images,
                   "image files or glob patterns, in the order of their names; baseline JPEG is "
                   "sent byte for byte")
      ->default_str("")
      ->type_name("GLOB");
  source->add_flag("--synthetic", options.synthetic,
                   "a desk with marker 40 (DICT_6X6_250, 0.05 m), filmed from a known path");
  source->add_flag("--list-cameras", options.list_cameras,
                   "print the numbers and names of the cameras, and end");
  source->require_option(1);
}

void add_sink(CLI::App& app, Options& options) {
  auto* sink = app.add_option_group("sink", "at most one of");
  sink->add_flag("--display", options.display, "a window; q or Escape ends");
  sink->add_option("--record", options.record, "film file")->type_name("FILE.mp4");
  sink->add_option("--output", options.output,
                   "folder for each composite as received, frame-000001.jpg by frame id")
      ->type_name("DIR");
  sink->require_option(0, 1);
}

}  // namespace

common::HostPort parse_server(const std::string& text) {
  try {
    const common::HostPort server = common::parse_host_port(text);
    if (server.port != 0) return server;
  } catch (const std::invalid_argument&) {
  }
  throw std::runtime_error("'" + text + "' is not HOST:PORT, as desk.example:7447 or [::1]:7447");
}

tracking::OneEuroOptions parse_smoothing(const std::string& text) {
  tracking::OneEuroOptions options;
  const char* const end = text.data() + text.size();
  auto result = std::from_chars(text.data(), end, options.min_cutoff);
  bool good = result.ec == std::errc();
  if (good && result.ptr != end) {
    good = *result.ptr == ':';
    if (good) result = std::from_chars(result.ptr + 1, end, options.beta);
    good = good && result.ec == std::errc() && result.ptr == end;
  }
  constexpr double kMaxCutoff = 1000.0;  // Hz; also what makes infinities fail
  good = good && options.min_cutoff > 0 && options.min_cutoff <= kMaxCutoff && options.beta >= 0 &&
         options.beta <= kMaxCutoff;
  if (!good) {
    throw std::runtime_error("'" + text +
                             "' is not MINCUTOFF[:BETA] with 0 < MINCUTOFF <= 1000 "
                             "and 0 <= BETA <= 1000");
  }
  return options;
}

cv::Size parse_size(const std::string& text) {
  const glm::ivec2 size = common::parse_image_size(text, static_cast<int>(protocol::kMaxSide));
  return {size.x, size.y};
}

std::optional<Options> parse_options(int argc, const char* const* argv) {
  Options options;
  CLI::App app("Sends camera images to an Amalgam server and receives them with virtual objects.",
               "amalgam-client");
  app.option_defaults()->always_capture_default();
  app.set_version_flag("--version", common::version_line("amalgam-client"));
  std::string server = "127.0.0.1:7447", size, synthetic_poses = "detected", smoothing;
  BoardTexts board;
  double connect_timeout = 5.0;
  app.add_option("--server", server, "server's address")
      ->type_name("HOST:PORT")
      ->check(checked_by(parse_server));
  app.add_option("--connect-timeout", connect_timeout,
                 "seconds to find the server, at first and after each loss")
      ->type_name("S")
      ->check(common::in_range(0.1, 3600.0));
  app.add_option("--token-file", options.token_file, "file with the server's secret")
      ->type_name("FILE");
  auto* const tls = app.add_flag("--tls", options.connection.tls,
                                 "encrypt, and ask the server for a certificate of its name");
  app.add_option("--ca", options.connection.certificate_authority,
                 "certificates that are trusted with --tls; without it the system's")
      ->type_name("PEM")
      ->needs(tls);
  add_source(app, options);
  add_sink(app, options);
  add_markers(app, board, smoothing, options.viewer.dead_band);
  auto* const calibration =
      app.add_option(
             "--calibration", options.calibration,
             "calibration of the lens (OpenCV, ROS, Kalibr; .yml, .xml or .json); without it "
             "60 degrees of width are assumed")
          ->type_name("FILE");
  auto* const calibrate =
      app.add_option("--calibrate", options.calibrate,
                     "instead, calibrate the lens with a board (--charuco, --grid or --board; "
                     "amalgam-marker prints one) and write this file for --calibration. Show it "
                     "from all sides, near and in all corners")
          ->type_name("FILE.yml")
          ->excludes(calibration);
  app.add_option("--dictionary", options.dictionary, "of the board's markers, with --calibrate")
      ->type_name("NAME")
      ->needs(calibrate);
  app.add_option("--fov", options.field_of_view,
                 "how wide the lens sees, where there is no calibration; its maker says so")
      ->type_name("DEGREES")
      ->check(common::in_range(5.0, 150.0))
      ->excludes(calibration);
  auto* environment =
      app.add_option(
             "--environment", options.environment,
             "equirectangular image of the surroundings, for the scene's light and "
             "reflections; all clients of the scene see them, except those that have their own")
          ->type_name("IMAGE");
  app.add_option("--environment-fisheye", options.environment_fisheye,
                 "calibration of the equidistant fish-eye lens that took it (.yml)")
      ->type_name("FILE")
      ->needs(environment);
  app.add_flag("--own-environment", options.own_environment,
               "the environment lights this client's composites only, which needs no right to "
               "change the light for all")
      ->needs(environment);
  app.add_option("--size", size,
                 "image size, pixels (default: the source's own; 800x600 for --synthetic)")
      ->type_name("WxH")
      ->check(checked_by(parse_size));
  app.add_option("--quality", options.composite_quality,
                 "JPEG quality of composites, 1 to 100; 0: the server's default, and unaffected "
                 "frames come back byte for byte")
      ->type_name("Q")
      ->check(common::in_range(0, 100));
  app.add_option("--camera-quality", options.camera_quality,
                 "JPEG quality of images that have to be encoded for sending, 1 to 100")
      ->type_name("Q")
      ->check(common::in_range(1, 100));
  app.add_flag("--synthetic-mirror", options.synthetic_mirror,
               "the real mirror of the complex scene stands on the desk of --synthetic");
  app.add_option("--synthetic-poses", synthetic_poses,
                 "poses of --synthetic: as detected in the image, or the true ones")
      ->type_name("detected|true")
      ->check(CLI::IsMember({"detected", "true"}));
  app.add_flag("--repeat-images", options.repeat_images, "begin --images again after the last");
  app.add_option("--frames", options.viewer.frames, "frames to capture; 0: until the source ends")
      ->type_name("N");
  app.add_option("--rate", options.viewer.rate,
                 "frames a second from files and --synthetic, and of --record")
      ->type_name("HZ")
      ->check(common::in_range(0.01, 1000.0));
  app.add_flag("--lockstep", options.viewer.lockstep,
               "wait for the answer to each frame before the next, whatever the rate");
  app.add_flag("--json", options.json, "print the summary as one JSON object");
  app.add_option("--log-level", options.log_level, "of messages on standard error")
      ->type_name("LEVEL")
      ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "off"}));
  if (!common::parse_command_line(app, argc, argv)) return std::nullopt;
  options.connection.server = parse_server(server);
  options.connection.connect_timeout =
      std::chrono::milliseconds(static_cast<std::int64_t>(connect_timeout * 1000.0));
  if (!size.empty()) options.size = parse_size(size);
  if (!smoothing.empty()) options.viewer.smoothing = parse_smoothing(smoothing);
  options.viewer.board = read_board(board);
  if (!options.calibrate.empty() && !options.viewer.board) {
    throw std::invalid_argument("--calibrate needs a board: --charuco, --grid or --board");
  }
  options.true_poses = synthetic_poses == "true";
  return options;
}

}  // namespace amalgam::client
