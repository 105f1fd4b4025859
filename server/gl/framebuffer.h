// Owns one OpenGL framebuffer: the textures that a pass draws into. Cheap enough to be made anew
// whenever a pass runs, so it never outlives a texture that was resized.
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
    glm::ivec2 size_of_none{0};  // if there is nothing attached: only to be counted in
  };

  // Throws std::runtime_error if the driver cannot draw into these together.
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
  void clear_depth() const;  // to 0: infinitely far, depth being reversed

 private:
  GLuint id_ = 0;
  glm::ivec2 size_{0};
};

}  // namespace amalgam::gl
