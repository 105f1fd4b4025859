#include "gl/buffer.h"

#include <array>
#include <utility>

#include "gl/gl_error.h"

namespace amalgam::gl {

Buffer::Buffer(std::span<const std::byte> bytes) {
  constexpr std::array<std::byte, 16> kNothing{};
  if (bytes.empty()) bytes = kNothing;
  glCreateBuffers(1, &id_);
  glNamedBufferStorage(id_, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), 0);
  try {
    throw_pending_gl_error("buffer of " + std::to_string(bytes.size()) + " bytes");
  } catch (...) {
    glDeleteBuffers(1, &id_);
    throw;
  }
}

Buffer::~Buffer() {
  if (id_ != 0) glDeleteBuffers(1, &id_);
}

Buffer::Buffer(Buffer&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

void Buffer::bind_uniform(GLuint binding) const {
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, id_);
}

void Buffer::bind_uniform_range(GLuint binding, std::size_t offset, std::size_t bytes) const {
  glBindBufferRange(GL_UNIFORM_BUFFER, binding, id_, static_cast<GLintptr>(offset),
                    static_cast<GLsizeiptr>(bytes));
}

void Buffer::bind_storage(GLuint binding) const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, id_);
}

}  // namespace amalgam::gl
