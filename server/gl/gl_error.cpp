#include "gl/gl_error.h"

#include <epoxy/gl.h>

#include <stdexcept>

#include "common/log.h"

namespace amalgam::gl {
namespace {

std::string error_name(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return "GL error " + std::to_string(error);
  }
}

void on_message(GLenum source, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* text,
                const void*) {
  // Shaders that do not compile are thrown by ShaderProgram, with their source.
  if (type != GL_DEBUG_TYPE_ERROR || source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
  const std::string message(text, static_cast<std::size_t>(length));
  common::log_error("OpenGL: " + message);
#ifndef NDEBUG
  // Out of memory is the machine's error; the allocating code throws it.
  AMALGAM_CHECK(message.find("GL_OUT_OF_MEMORY") != std::string::npos, message);
#endif
}

}  // namespace

void report_gl_errors() {
  glEnable(GL_DEBUG_OUTPUT);
#ifndef NDEBUG
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);  // so that the stack shows the faulty call
#endif
  glDebugMessageCallback(on_message, nullptr);
}

void throw_pending_gl_error(const std::string& doing) {
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) throw std::runtime_error(doing + ": " + error_name(error));
}

}  // namespace amalgam::gl
