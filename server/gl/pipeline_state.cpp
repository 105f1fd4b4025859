#include "gl/pipeline_state.h"

#include <epoxy/gl.h>

namespace amalgam::gl {
namespace {

void enable(GLenum capability, bool on) {
  if (on) {
    glEnable(capability);
  } else {
    glDisable(capability);
  }
}

}  // namespace

void apply(const PipelineState& state) {
  using Depth = PipelineState::Depth;
  using Blend = PipelineState::Blend;
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DITHER);
  glDisable(GL_MULTISAMPLE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

  enable(GL_DEPTH_TEST, state.depth != Depth::Off);
  glDepthFunc(state.depth == Depth::EqualReads ? GL_EQUAL : GL_GREATER);
  // Clearing obeys this mask: whoever clears depth also writes it.
  glDepthMask(state.depth == Depth::EqualReads ? GL_FALSE : GL_TRUE);

  enable(GL_BLEND, state.blend != Blend::Off);
  glBlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
  glBlendFunc(GL_ONE, GL_ONE);

  // Slope-scaled by one texel, and a few steps of the float depth against rounding.
  enable(GL_POLYGON_OFFSET_FILL, state.push_depth_away);
  glPolygonOffset(-1.0f, -4.0f);
}

}  // namespace amalgam::gl
