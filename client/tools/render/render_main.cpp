// amalgam-render: one frame without a network, by the same renderer as the server's.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "client/tools/render/provenance_picture.h"
#include "client/tools/render/render_input.h"
#include "client/tools/render/render_report.h"
#include "common/build_info.h"
#include "common/image_size.h"
#include "common/log.h"
#include "common/parse_command_line.h"
#include "common/run_program.h"
#include "common/whole_file.h"
#include "frame/frame_renderer.h"
#include "frame/rendering_threads.h"
#include "scene/gltf/loader.h"
#include "scene/likely_mistakes.h"
#include "server/renderer_options.h"

namespace {

using namespace amalgam;

struct Options {
  std::string scene = tools::default_scene_path();
  tools::RenderInputOptions input;
  frame::RendererSettings renderer;
  std::string output, dump, graph;
  int repeat = 1;
  bool still = false, json = false, explain = false;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--scene", options.scene, "glTF scene (.gltf, .glb)")->capture_default_str();
  app.add_option("--camera-image", options.input.camera_image, "picture that the camera took");
  app.add_option(
      "--calibration", options.input.calibration,
      "camera file of OpenCV, ROS or Kalibr; without it 60 degrees wide and no distortion");
  app.add_option(
      "--poses", options.input.poses,
      "JSON file: {\"poses\": [{\"marker\": 40, \"rotation\": [x, y, z, w], \"translation\": [x, "
      "y, "
      "z]}, ...]}; camera_from_marker, metres, camera with x right, y down and z forward as in "
      "PROTOCOL.md, a unit quaternion; as --json prints them; without it markers are looked for in "
      "the image");
  app.add_option_function<std::string>(
         "--size",
         [&options](const std::string& text) {
           constexpr int kMaxSide = 8192;  // of common::describe_defect()
           const glm::ivec2 size = common::parse_image_size(text, kMaxSide);
           options.input.width = size.x;
           options.input.height = size.y;
         },
         "WxH in pixels, without --camera-image: mid grey")
      ->default_str("640x480");
  app.add_option("--output", options.output, "picture to write the composite to: .png, or .jpg");
  tools::add_renderer_options(app, options.renderer);
  app.add_option(
      "--dump", options.dump,
      "folder to write every buffer to, as EXR, and where light came from as a picture; "
      "with several samples, over and difference are their averages after refinement, the "
      "others the first sample of each pixel before it, (n - 1) / 2n of a pixel up and left "
      "of the middle (the files' comments say which)");
  app.add_option("--graph", options.graph, "file to write the frame graph to, for Graphviz");
  app.add_option("--repeat", options.repeat, "render the frame so many times, for timing")
      ->check(common::in_range(1, 100000))
      ->capture_default_str();
  app.add_flag("--still", options.still,
               "with --repeat: time what a camera on a tripod costs, of which nothing moves; "
               "without it, a moving camera");
  app.add_flag("--json", options.json, "print times (ms), ray counts, passes and pixel counts");
  app.add_flag("--explain", options.explain, "print each pass, or why it was left out");
}

// Before anything is rendered for it.
void check_picture(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".png" && extension != ".jpg" && extension != ".jpeg") {
    throw std::runtime_error(path + ": pictures are written as .png or .jpg");
  }
}

void write_picture(const std::string& path, common::ImageRgb8 image) {
  cv::Mat rgb(image.height(), image.width(), CV_8UC3, image.data());
  cv::cvtColor(rgb, rgb, cv::COLOR_RGB2BGR);
  std::vector<unsigned char> encoded;
  cv::imencode(std::filesystem::path(path).extension().string(), rgb, encoded);
  common::write_whole_file(path, {reinterpret_cast<const char*>(encoded.data()), encoded.size()});
}

void run(const Options& options) {
  frame::RendererSettings settings = options.renderer;
  settings.reuse_still_frames = options.still;
  frame::FrameRenderer renderer(scene::load_scene(options.scene), settings);
  for (const std::string& warning : renderer.scene().warnings) common::log_warn(warning);
  for (const std::string& note : renderer.scene().notes) common::log_debug(note);
  tools::RenderInput input = tools::load_render_input(options.input, renderer.scene());
  const std::string warning = tools::describe_missing_markers(input, renderer.scene());
  if (!warning.empty()) common::log_warn(warning);
  for (const common::MarkerPose& pose : input.frame.poses) {
    const glm::dvec3 camera = glm::inverse(pose.rotation) * -pose.translation;
    for (const std::string& node : scene::nodes_around(renderer.scene(), pose.marker, camera)) {
      common::log_warn("the camera is inside the model " + node);
    }
  }
  frame::ViewOptions view_options{.camera = input.camera};
  view_options.keep_pixels = true;
  frame::ViewState view(view_options);

  frame::FrameBuffers buffers;
  std::vector<frame::FrameOutput> frames;
  for (int i = 0; i < options.repeat; ++i) {
    const bool last = i + 1 == options.repeat;
    // Provenance is not kept of a frame that is not traced.
    view.options.keep_provenance =
        last && ((options.json && !options.still) || !options.dump.empty());
    frames.push_back(
        renderer.render(view, input.frame, last && !options.dump.empty() ? &buffers : nullptr));
    if (!last) frames.back().pixels = {};
  }
  if (!options.output.empty()) write_picture(options.output, frames.back().pixels);
  if (!options.dump.empty()) {
    frame::write_buffers(buffers, options.dump);
    if (const auto& provenance = frames.back().provenance) {
      tools::write_provenance_picture(*provenance,
                                      std::filesystem::path(options.dump) / "provenance.png");
    }
  }
  if (!options.graph.empty()) common::write_whole_file(options.graph, renderer.last_graph());
  if (options.explain) tools::print_passes(options.json ? std::cerr : std::cout, frames.back());
  if (options.json) tools::print_json(std::cout, frames, input.frame.poses);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Renders one mixed-reality frame: virtual objects into a camera image.",
               "amalgam-render");
  Options options;
  add_options(app, options);
  app.set_version_flag("--version", [] {
    return common::version_line("amalgam-render") + "; " + frame::ray_tracer_version();
  });
  return common::run_program("amalgam-render", [&] {
    if (!common::parse_command_line(app, argc, argv)) return 0;
    if (!options.output.empty()) check_picture(options.output);
    frame::limit_llvmpipe_threads(options.renderer);
    run(options);
    return 0;
  });
}
