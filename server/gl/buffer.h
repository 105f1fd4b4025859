// Owns one immutable OpenGL buffer: vertices, indices, uniforms or shader storage.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <span>

namespace amalgam::gl {

class Buffer {
 public:
  // A copy of the bytes. An empty span gives a buffer of 16 zero bytes, so that it can be bound.
  explicit Buffer(std::span<const std::byte> bytes);
  template <typename T>
  static Buffer of(std::span<const T> values) {
    return Buffer(std::as_bytes(values));
  }
  ~Buffer();
  Buffer(Buffer&& other) noexcept;
  Buffer& operator=(Buffer&& other) noexcept;
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  GLuint id() const { return id_; }
  void bind_uniform(GLuint binding) const;
  void bind_uniform_range(GLuint binding, std::size_t offset, std::size_t bytes) const;
  void bind_storage(GLuint binding) const;

 private:
  GLuint id_ = 0;
};

}  // namespace amalgam::gl
