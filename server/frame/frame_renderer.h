// One scene, rendered into any number of camera views, one frame at a time.
//
// Belongs to the thread that made it, which owns the OpenGL context.
#pragma once

#include <memory>

#include "frame/buffer_dump.h"
#include "frame/frame.h"
#include "frame/renderer_settings.h"
#include "frame/view_state.h"
#include "scene/scene.h"

namespace amalgam::frame {

class FrameRenderer {
 public:
  // Throws std::runtime_error without a usable GPU or Mesa; std::invalid_argument for bad settings.
  FrameRenderer(scene::Scene scene, const RendererSettings& settings);
  ~FrameRenderer();

  // Throws codec::JpegError if the camera image cannot be used, core::Cancelled if input.progress
  // says so. buffers: filled if given.
  FrameOutput render(ViewState& view, const FrameInput& input, FrameBuffers* buffers = nullptr);

  // Replaces the scene's environment for all views without their own. Its lights are extracted
  // once, with the next frame.
  void set_environment(scene::Environment environment);
  // The view keeps its own environment, whatever becomes of the scene's.
  void set_own_environment(ViewState& view, scene::Environment environment);

  // Frees the textures and buffers that are kept for the next frame, which then makes them again.
  void free_targets();

  // After another renderer was made on this thread: this one's OpenGL context is used again.
  void make_current();

  // What it draws and traces with, for people.
  std::string hardware() const;

  // Without its environment, which is kept apart.
  const scene::Scene& scene() const;
  // The last frame's graph in Graphviz's language.
  const std::string& last_graph() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace amalgam::frame
