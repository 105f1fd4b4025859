// A renderer with one view and one frame that it renders again and again.
//
// A renderer's thread owns an OpenGL context, and a thread has one context at a time; measuring two
// renderers by turns therefore needs a thread for each.
#pragma once

#include <functional>
#include <future>
#include <memory>

#include "bench/bench_case.h"
#include "frame/buffer_dump.h"
#include "frame/frame.h"
#include "frame/renderer_settings.h"

namespace amalgam::bench {

// How everything in the bench is rendered unless the measurement says otherwise: the default
// quality, on as many threads as the bench has cores.
frame::RendererSettings default_settings();

struct RigOptions {
  bool keep_pixels = false;  // frames come with the composite's pixels
  int jpeg_quality = 0;      // as frame::ViewOptions has it
};

class RenderRig {
 public:
  // Renders one frame at once, so that what is made once has been made. The case must outlive the
  // rig. Throws what FrameRenderer throws.
  RenderRig(const BenchCase& bench_case, const frame::RendererSettings& settings,
            const RigOptions& options = {});
  ~RenderRig();

  // One frame, from the client's JPEG to the composite's. Blocks until it is done.
  frame::FrameOutput render();
  // The same of another input of the same camera. buffers: filled if given; that costs time.
  frame::FrameOutput render(const frame::FrameInput& input, frame::FrameBuffers* buffers = nullptr);

  // From now on frames are those of a new view, of another camera.
  void look_through(const common::CameraModel& camera, const RigOptions& options = {});

  // Wall-clock time of render().
  double render_milliseconds();
  // Times of a first frame: all that later ones find made.
  double first_milliseconds() const { return first_milliseconds_; }

 private:
  class Worker;

  const BenchCase& case_;
  double first_milliseconds_ = 0.0;
  std::unique_ptr<Worker> worker_;
};

// Median time of a frame: of as many as go into the seconds, but at least one. The first frame
// counts only if it alone takes so long that no other is worth waiting for.
double median_frame_milliseconds(RenderRig& rig, double seconds);

}  // namespace amalgam::bench
