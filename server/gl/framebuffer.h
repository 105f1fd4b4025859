// Owns one OpenGL framebuffer: the textures that a pass draws into. Cheap, so each run of a pass
// makes its own, and none outlives a resized texture.
#pragma once

#include <epoxy/gl.h>

#include <glm/vec4.hpp>
#include <vector>

#include "gl/texture.h"

namespace amalgam::gl {

class Framebuffer {
 public:
  struct Attachments {
    std::vector<const Texture*> colors{};
    const Texture* depth = nullptr;
    int layer = 0;               // of array textures
    glm::ivec2 size_of_none{0};  // size without attachments
  };

  // Throws std::runtime_error if the driver does not support this combination.
  explicit Framebuffer(const Attachments& attachments);
  ~Framebuffer();
  Framebuffer(Framebuffer&& other) noexcept;
  Framebuffer& operator=(Framebuffer&& other) noexcept;
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  GLuint id() const { return id_; }
  void bind() const;  // and sets the viewport to the textures' size

  void clear_color(int attachment, const glm::vec4& value) const;
  void clear_color(int attachment, const glm::uvec4& value) const;
  void clear_depth() const;  // to 0: infinitely far (reversed depth)

 private:
  GLuint id_ = 0;
  glm::ivec2 size_{0};
};

}  // namespace amalgam::gl
