#include "gl/framebuffer.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace amalgam::gl {
namespace {

void attach(GLuint framebuffer, GLenum point, const Texture& texture, int layer) {
  if (texture.is_array()) {
    glNamedFramebufferTextureLayer(framebuffer, point, texture.id(), 0, layer);
  } else {
    glNamedFramebufferTexture(framebuffer, point, texture.id(), 0);
  }
}

}  // namespace

Framebuffer::Framebuffer(const Attachments& attachments) {
  glCreateFramebuffers(1, &id_);
  std::vector<GLenum> buffers;
  for (const Texture* color : attachments.colors) {
    const GLenum point = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
    attach(id_, point, *color, attachments.layer);
    buffers.push_back(point);
    size_ = color->size();
  }
  if (attachments.depth != nullptr) {
    attach(id_, GL_DEPTH_ATTACHMENT, *attachments.depth, attachments.layer);
    size_ = attachments.depth->size();
  }
  if (attachments.colors.empty() && attachments.depth == nullptr) {
    size_ = attachments.size_of_none;
    glNamedFramebufferParameteri(id_, GL_FRAMEBUFFER_DEFAULT_WIDTH, size_.x);
    glNamedFramebufferParameteri(id_, GL_FRAMEBUFFER_DEFAULT_HEIGHT, size_.y);
  }
  if (buffers.empty()) {
    glNamedFramebufferDrawBuffer(id_, GL_NONE);
    glNamedFramebufferReadBuffer(id_, GL_NONE);
  } else {
    glNamedFramebufferDrawBuffers(id_, static_cast<GLsizei>(buffers.size()), buffers.data());
  }
  const GLenum status = glCheckNamedFramebufferStatus(id_, GL_DRAW_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    glDeleteFramebuffers(1, &id_);
    throw std::runtime_error("framebuffer is not complete, status " + std::to_string(status));
  }
}

Framebuffer::~Framebuffer() {
  if (id_ != 0) glDeleteFramebuffers(1, &id_);
}

Framebuffer::Framebuffer(Framebuffer&& other) noexcept
    : id_(std::exchange(other.id_, 0)), size_(other.size_) {}

Framebuffer& Framebuffer::operator=(Framebuffer&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(size_, other.size_);
  return *this;
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, id_);
  glViewport(0, 0, size_.x, size_.y);
}

void Framebuffer::clear_color(int attachment, const glm::vec4& value) const {
  glClearNamedFramebufferfv(id_, GL_COLOR, attachment, &value.x);
}

void Framebuffer::clear_color(int attachment, const glm::uvec4& value) const {
  glClearNamedFramebufferuiv(id_, GL_COLOR, attachment, &value.x);
}

void Framebuffer::clear_depth() const {
  const GLfloat far = 0.0f;
  glClearNamedFramebufferfv(id_, GL_DEPTH, 0, &far);
}

}  // namespace amalgam::gl
