// Owns one OpenGL texture: two-dimensional, or an array of layers; immutable storage, one level.
//
// Row 0 is the top of the picture (see passes/raster/upload_view.h), so nothing is ever flipped.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <glm/vec2.hpp>

namespace amalgam::gl {

enum class TextureFormat : std::uint8_t { R8ui, Rgba8ui, Rgba32f, Depth32f };

class Texture {
 public:
  // layers: 0 for a two-dimensional texture, otherwise an array. Throws std::runtime_error if the
  // driver is out of memory or a side exceeds its limit.
  Texture(TextureFormat format, glm::ivec2 size, int layers = 0);
  ~Texture();
  Texture(Texture&& other) noexcept;
  Texture& operator=(Texture&& other) noexcept;
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  GLuint id() const { return id_; }
  TextureFormat format() const { return format_; }
  glm::ivec2 size() const { return size_; }
  int layers() const { return layers_; }
  bool is_array() const { return layers_ > 0; }

  // Rows of tightly packed texels, top row first. Two-dimensional textures only. All throw
  // std::runtime_error if this or anything that was drawn before failed in the driver.
  void upload(const void* texels);
  void read(void* texels, std::size_t bytes) const;  // bytes: exactly what the texture holds
  // size texels from first on, of one layer of an array. bytes as for read().
  void read_part(glm::ivec2 first, glm::ivec2 size, void* texels, std::size_t bytes,
                 int layer = 0) const;
  // Sets every channel of a part of a two-dimensional float or depth texture. An error stays
  // pending (gl/gl_error.h).
  void clear_part(glm::ivec2 first, glm::ivec2 size, float value) const;

  // Makes texels outside 0: as reversed depth, infinitely far.
  void set_zero_outside();

  void bind(GLuint unit) const;

 private:
  GLuint id_ = 0;
  TextureFormat format_;
  glm::ivec2 size_;
  int layers_;
};

// Bytes of one texel.
std::size_t texel_bytes(TextureFormat format);

}  // namespace amalgam::gl
