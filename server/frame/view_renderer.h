// What a RenderThread renders with.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "frame/frame.h"

namespace amalgam::frame {

// Made, used and destroyed on the render thread. All functions may throw; Cancelled and
// codec::JpegError have a meaning of their own.
class ViewRenderer {
 public:
  // What it keeps of a view from frame to frame.
  class State {
   public:
    virtual ~State() = default;
  };

  virtual ~ViewRenderer() = default;
  virtual std::unique_ptr<State> open(const ViewOptions& options) = 0;
  virtual FrameOutput render(State& view, const FrameInput& input) = 0;
  // For all views without their own.
  virtual void set_environment(const EnvironmentInput& input) = 0;
  // For one view.
  virtual void set_own_environment(State& view, const EnvironmentInput& input) = 0;
  // Frees what is kept from frame to frame for the size of its views. The next frame makes again
  // what it needs.
  virtual void free_targets() {}
  virtual FrameService::MarkerSet markers() const = 0;
  virtual FrameService::Fingerprint fingerprint() const { return {}; }
  // Another renderer was made on this thread, but this one goes on.
  virtual void stay() {}
  // Of a frame, measured when it was made; 0: not known.
  virtual double seconds_per_pixel() const { return 0.0; }
};

using MakeRenderer = std::function<std::unique_ptr<ViewRenderer>()>;

}  // namespace amalgam::frame
