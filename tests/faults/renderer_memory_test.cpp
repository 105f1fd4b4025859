// Row 37: the renderer gives back what a large view needed.
#include <gtest/gtest.h>
#include <malloc.h>

#include <chrono>
#include <semaphore>
#include <thread>
#include <variant>

#include "codec/jpeg.h"
#include "faults/figure.h"
#include "frame/default_view.h"
#include "frame/render_thread.h"
#include "net/memory_trim.h"
#include "net/process_figures.h"

namespace amalgam::test {
namespace {

double resident_mib() {
  ::malloc_trim(0);  // as amalgam-server does when a session has ended
  return static_cast<double>(net::read_process_figures().resident_bytes) / (1024.0 * 1024.0);
}

class View {
 public:
  View(frame::RenderThread& service, int width, int height)
      : service_(service),
        id_(service.open_view({.camera = common::default_camera(width, height)},
                              [this](std::uint64_t, const frame::FrameResult& result) {
                                rendered_ = std::holds_alternative<frame::FrameOutput>(result);
                                done_.release();
                              })),
        jpeg_(codec::encode_jpeg({width, height, common::Rgb8(128)}, 90)) {}
  ~View() { service_.close_view(id_); }

  // shift: metres, so that nothing of the frame before is kept.
  bool render(double shift) {
    common::MarkerPose pose = frame::default_pose(service_.markers().world_marker);
    pose.translation.x += shift;
    service_.submit(id_, 1, {jpeg_, {pose}});
    done_.acquire();
    return rendered_;
  }

 private:
  frame::RenderThread& service_;
  std::binary_semaphore done_{0};
  bool rendered_ = false;
  frame::ViewId id_;
  frame::Bytes jpeg_;
};

TEST(RendererMemory, ALargeViewLeavesNothingBehind) {
  net::share_one_heap();  // as amalgam-server does
  frame::RenderThread service(AMALGAM_SOURCE_DIR "/deploy/scenes/complex.gltf", {});
  View small(service, 320, 240);
  double shift = 0.0;
  const auto render = [&](View& view) {
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(view.render(shift += 0.001));
  };
  // What the first large view of all brings with it is not counted: code, and the driver's own.
  for (int i = 0; i < 2; ++i) {
    render(small);
    View large(service, 1280, 1024);
    render(large);
  }
  render(small);
  const double before = resident_mib();
  double during = 0.0;
  {
    View large(service, 1280, 1024);
    render(large);
    during = resident_mib() - before;
  }
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  double kept = resident_mib() - before;
  while (kept > 2.0 && seconds() < 15.0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    kept = resident_mib() - before;
  }
  print_figure("37", "a view of 1280 x 1024 takes", during, "MiB", "-");
  print_figure("37", "it leaves behind", kept, "MiB", "<= 2 MiB after 5 s");
  print_figure("37", "given back after", seconds(), "s", "<= 5 s");
  EXPECT_LE(kept, 2.0);
}

}  // namespace
}  // namespace amalgam::test
